// SeenAlong projects two convex polygons in space along a normal n. It computes exactly which of their vertices, edges
// and faces share a point in this projection, and the points on both polygons.
//
// Seen along n, a point c is on the left of the edge from p to q if (c - p) . (n x (q - p)) > 0. All numbers are sums
// and products of given doubles, in integers of any length; nothing is rounded.
#pragma once

#include <array>
#include <vector>

#include "exact/number/long_vector.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/patch/corner_order.hpp"

namespace ecods::patches {

using exact::ScaledInteger;
using exact::ScaledLongVector;

// ExactNormal is a vector n from the first body to the second, with the square of its length.
struct ExactNormal {
    ScaledLongVector n;
    ScaledInteger square;
};
// Returns the normal of the least difference of two hulls.
ExactNormal scaled_normal(convex::PosedHulls& hulls, const convex::LeastDifference& least);

// LongPoint is the point num / den, with den > 0.
struct LongPoint {
    ScaledLongVector num;
    ScaledInteger den{1.0};
};

// LongCorner is a corner of a patch: a point on each body, and num / den = n . (second - first), with den > 0. The
// quotient num / den is |n| times the gap.
struct LongCorner {
    std::array<LongPoint, 2> at;
    ScaledInteger num, den;
};

class SeenAlong final : public Turn {
  public:
    // The constructor requires that no two vertices of one polygon coincide, seen along the normal. The polygons and
    // the normal must outlive this object.
    SeenAlong(const convex::PosedHulls& hulls, const Polygons& polygons, const ExactNormal& normal);

    // Sets `pairs` to all pairs of features whose relative interiors, as seen along the normal, share exactly one
    // point.
    void list(convex::LeastPairs& pairs);
    int of(const HullFeaturePair& edges) const override;
    // Returns the patch's corner at the one point that the two features of `pair` share, as seen along the normal.
    LongCorner corner(const HullFeaturePair& pair) const;

  private:
    // An Edge from p has a point c on its left if (c - p) . left > 0, and c is further along it than p if (c - p) .
    // along > 0.
    struct Edge {
        ScaledLongVector way, left, along;
    };
    const ScaledLongVector& point(std::size_t side, std::size_t i) const noexcept { return points_[side][i]; }
    const ScaledLongVector& point_of(std::size_t side, const HullFeature& part) const noexcept {
        return point(side, polygons_[side].index_of(part));
    }
    // Returns 1 if a vertex of the other polygon is on the left of edge i, -1 if it is on the right, 0 if it is on the
    // line.
    int sign(std::size_t side, std::size_t i, std::size_t vertex) const noexcept {
        return signs_[side][i * points_[1 - side].size() + vertex];
    }
    HullFeature feature_below(std::size_t side, std::size_t vertex, bool& is_over) const;
    HullFeature on_edge(std::size_t of, const ScaledLongVector& c, bool& is_over) const;
    bool do_cross(std::size_t i, std::size_t j) const noexcept;
    LongPoint foot_on_edge(std::size_t of, std::size_t i, const ScaledLongVector& c) const;
    LongPoint foot_on_face(std::size_t of, const ScaledLongVector& c) const;

    const Polygons& polygons_;
    const ExactNormal& normal_;
    std::array<std::vector<ScaledLongVector>, 2> points_;  // by vertex
    std::array<std::vector<Edge>, 2> edges_;
    std::array<std::vector<int>, 2> signs_;  // by edge, and by vertex of the other polygon; empty before list()
};

}  // namespace ecods::patches
