// Decides when pairs of triangles of two meshes moving between poses first share a point: by bounds, and exactly. Exact
// decisions are kept for pairs with the same features.
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
    // Everything that the arguments refer to must outlive this.
    void bind(const Moving<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts);

    // An interval of [from, to] that contains the first common point, if there is one; nullopt if there is none up to
    // `to`.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort);

    // The triangles' first meeting if it is at most `to`; a later one may be left out. They must share no point before
    // `time`.
    std::optional<exact::Meeting> decide(const TrianglePair& triangles, exact::TimeSpan time, double to);

  private:
    // The first meeting of two features through which alone two triangles can meet. Other triangles that can meet only
    // through the same features meet at the same time.
    struct KnownMeeting {
        FeatureKey a, b;
        double time;
        bool is_late;
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
    exact::Frame frame_;  // of a and b at the start, then of both at the end
    std::vector<KnownMeeting> known_;
};

}  // namespace ecods
