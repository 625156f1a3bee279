// Pairs of triangles of two meshes on their way between poses: bounds of when they first share a point, and the exact
// decision, which knows what it has decided of the same features.
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
    // Everything that the arguments refer to must outlive the questions.
    void bind(const Moving<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts);

    // The first time in [from, to] in which the triangles may share a point; nothing if they share none up to `to`.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);

    // Their first meeting, if it is at `to` or before; otherwise maybe nothing. They share no point before `time`.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  private:
    // The first meeting of two features, where two triangles can only meet by these. Other triangles that have both
    // meet by them at the same time, if they do by no others.
    struct KnownMeeting {
        FeatureKey a, b;
        double time;
        bool is_late;
    };

    std::optional<exact::TimeSpan> bound_at_beginning(const exact::MovingPoints& points, double from, double to,
                                                      exact::Effort effort);
    std::array<exact::VertexRef, 12> corners_of(const TrianglePair& triangles) const;  // at the start, at the end
    exact::MovingPoints points_of(const TrianglePair& triangles);
    template <class Ask>
    auto ask_exactly(const TrianglePair& triangles, Ask&& ask);
    const KnownMeeting* find_known(const FeatureKey& a, const FeatureKey& b, const exact::TimeSpan& time) const;

    const Moving<MeshShape>* a_ = nullptr;
    const Moving<MeshShape>* b_ = nullptr;
    CastCounts* counts_ = nullptr;
    exact::Frame frame_;  // of a and b at the start, then at the end
    std::vector<KnownMeeting> known_;
};

}  // namespace ecods
