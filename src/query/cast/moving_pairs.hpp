// MovingPairs finds when pairs of triangles of two moving meshes first share a point, by bounds and exactly. It caches
// exact results, for other pairs of triangles that meet in the same features.
#pragma once

#include <array>
#include <optional>

#include "ecods/cast.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/decide_meeting.hpp"
#include "query/cast/mesh_at_ends.hpp"

namespace ecods {

class MovingPairs {
  public:
    // Binds two meshes that move straight. All objects that the arguments refer to must outlive this object.
    void bind(const MeshAtEnds& a, const MeshAtEnds& b, CastCounts& counts);

    // Returns an interval within [from, to] that contains the first time at which the triangles share a point, if they
    // share one by `to`. Returns nullopt if they certainly share no point from `from` to `to`.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);

    // Returns the first meeting of the triangles if its time is at most `to`; if the meeting is later, may return
    // nullopt. Call this function only if the triangles share no point before `time`.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  private:
    friend class MeetingDecision<MovingPairs>;
    const Mesh& mesh(std::size_t side) const noexcept { return *frame_.body(side).mesh; }
    exact::MovingPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);
    template <class Function>
    auto ask_translated(const TrianglePair& triangles, Function& ask);

    std::optional<exact::TimeSpan> bound_at_beginning(const exact::MovingPoints& points, double from, double to,
                                                      exact::Effort effort);
    std::array<exact::VertexRef, 12> corners_of(const TrianglePair& triangles) const;  // at the start, then at the end

    CastCounts* counts_ = nullptr;
    exact::Frame frame_;                         // bodies 0 and 1: a and b at the start; 2 and 3: a and b at the end
    std::array<const Vec3*, 2> translations_{};  // as in MeshAtEnds
    std::array<double, 2> ends_off_{};
    KnownMeetings known_;
};

}  // namespace ecods
