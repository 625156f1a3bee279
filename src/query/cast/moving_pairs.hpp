// MovingPairs finds when pairs of triangles of two moving meshes first share a point, by bounds and exactly. It caches
// exact results, for other pairs of triangles that meet in the same features.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/point/frame.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

class MovingPairs {
  public:
    // Everything that the arguments refer to must outlive this object.
    void bind(const Moving<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts);

    // Returns an interval within [from, to] that contains the first time at which the triangles share a point, if they
    // do so by `to`. Returns nullopt if they certainly do not.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);

    // Returns the first meeting of the triangles if its time is at most `to`; for a later one, may return nullopt. Call
    // only if the triangles share no point before `time`.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  private:
    // Stores when features a and b first share a point. It is stored only if the triangles that have them cannot meet,
    // in the time span searched, in any other features. So all triangles with this property first meet at this time.
    struct KnownMeeting {
        FeatureKey a, b;
        double time;   // rounded once
        bool is_late;  // true if the exact time is above `time`
    };

    std::optional<exact::TimeSpan> bound_at_beginning(const exact::MovingPoints& points, double from, double to,
                                                      exact::Effort effort);
    std::array<exact::VertexRef, 12> corners_of(const TrianglePair& triangles) const;  // at the start, then at the end
    exact::MovingPoints points_of(const TrianglePair& triangles);
    template <class Function>
    auto ask_exactly(const TrianglePair& triangles, Function&& ask);
    const KnownMeeting* find_known(const FeatureKey& a, const FeatureKey& b, const exact::TimeSpan& time) const;

    const Moving<MeshShape>* a_ = nullptr;
    const Moving<MeshShape>* b_ = nullptr;
    CastCounts* counts_ = nullptr;
    exact::Frame frame_;  // bodies 0 and 1: a and b at the start; 2 and 3: a and b at the end
    std::vector<KnownMeeting> known_;
};

}  // namespace ecods
