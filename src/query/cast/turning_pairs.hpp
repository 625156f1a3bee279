// TurningPairs finds when pairs of triangles first share a point, one of a mesh that turns and one of a mesh that is
// translated or at rest, by bounds and exactly.
#pragma once

#include <array>
#include <optional>

#include "ecods/turn.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/decide_meeting.hpp"

namespace ecods {

class TurningPairs {
  public:
    // Everything that the arguments refer to must outlive this object.
    // `motion` is the vector by which b is translated in the time from 0 to 1.
    void bind(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, CastCounts& counts);

    // Both do what those of MovingPairs do.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  protected:
    const exact::TurnAngles& angles() const noexcept { return angles_; }
    // The pivot at time 0, and how far it goes beside the other body; the sum of magnitudes of both ways. All
    // coordinates are relative to the translation of the pose at the start, which is rounded once.
    const exact::Point& pivot() const noexcept { return pivot_; }
    const exact::Point& glide() const noexcept { return glide_; }
    double way_size() const noexcept { return way_size_; }

  private:
    friend class MeetingDecision<TurningPairs>;
    const Mesh& mesh(std::size_t side) const noexcept { return side == 0 ? a_->what->mesh() : b_->what->mesh(); }
    std::array<exact::VertexRef, 6> corners_of(const TrianglePair& triangles) const;
    exact::TurningPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);

    const Turning<MeshShape>* a_ = nullptr;
    const Posed<MeshShape>* b_ = nullptr;
    const Vec3* motion_ = nullptr;
    CastCounts* counts_ = nullptr;
    exact::Frame frame_;
    exact::TurnAngles angles_;
    exact::Point pivot_{}, glide_{};
    double way_size_ = 0;
    std::optional<exact::TurnIntegers> integers_;  // made when a pair is first decided exactly
    KnownMeetings known_;
};

}  // namespace ecods
