// PlanarFeatures projects the features on which the closest, or deepest, points of two convex solids lie to polygons in
// one plane.
//
// All pairs of closest or deepest points differ by one vector w, from the first solid to the second. Both features are
// perpendicular to w, or to the normal of the depth if w is zero. So if the second feature is moved by -w, both are in
// one plane, and a pair of points becomes one point. The polygons are convex there. They stay convex if one coordinate
// is left out: the one in which the normal is largest. Then a few signs in the plane decide about features.
//
// Bounds. A rounded point is off by delta, and w by at most 2^-50 |w| for each coordinate, as it is a product of a
// length and a direction that are rounded once or twice. Moving rounds by at most delta + 2^-52 |w|, since 2^-52 of
// each coordinate is below delta. Together a coordinate is off by less than eta = 2 delta + 2^-49 |w|. Let all
// differences from a to b be at most B in magnitude, and from a to c at most C. A difference is off by 2 eta and its
// rounding, so the sum (b - a) x (c - a) of two products is off by less than 4 eta (B + C) + 8 eta^2 and, by four
// roundings of each product, 2^-49 B C. Twice these terms also cover terms of higher order. Underflow loses less than
// 2^-900.
// Claim: verify/proofs/planar_features.py
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "query/convex/hull_features.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

class PlanarFeatures {
  public:
    // `normal` is a unit vector perpendicular to both features, each coordinate rounded once, and w is `along` times
    // this vector, in the unit of rounded points. `along` is off by at most 2^-51 of its magnitude. If it is infinite,
    // w is unknown, and all answers are open.
    PlanarFeatures(const PosedHulls& hulls, const std::array<HullFeature, 2>& parts, const Vec3& normal, double along);

    std::size_t vertex_count(std::size_t side) const noexcept { return of_[side].size(); }
    std::size_t edge_count(std::size_t side) const noexcept {
        return of_[side].size() < 3 ? of_[side].size() - 1 : of_[side].size();
    }
    HullFeature vertex(std::size_t side, std::size_t i) const noexcept {
        return {Feature::Kind::vertex, of_[side][i].vertex};
    }
    // Returns the edge from vertex i to the next one.
    HullFeature edge(std::size_t side, std::size_t i) const noexcept {
        return {Feature::Kind::edge, of_[side][i].edge};
    }

    // Returns false if vertex i of the first polygon is certainly not at vertex j of the second.
    bool may_meet(std::size_t i, std::size_t j) const noexcept;
    // Returns false if vertex i of polygon `side` is certainly not on edge j of the other polygon.
    bool may_be_on(std::size_t side, std::size_t i, std::size_t j) const noexcept;

    enum class Answer : std::uint8_t { no, yes, open };
    // Says whether vertex i of polygon `side` is inside the other polygon, which must be a face.
    Answer is_inside(std::size_t side, std::size_t i) const noexcept;
    // Says whether edge i of the first polygon and edge j of the second cross in their interiors.
    Answer do_cross(std::size_t i, std::size_t j) const noexcept;

  private:
    struct Corner {
        double x, y;
        std::uint32_t vertex, edge;
    };
    void add(const PosedHulls& hulls, std::size_t side, std::uint32_t vertex, std::uint32_t edge);
    const Corner& next(std::size_t side, std::size_t i) const noexcept {
        return of_[side][i + 1 == of_[side].size() ? 0 : i + 1];
    }
    // Returns true if the boxes around two segments are certainly apart.
    bool are_apart(const Corner& a, const Corner& b, const Corner& c, const Corner& d) const noexcept;
    // Returns the side of edge i on which a corner is, as a sign; 0 if it is not certain.
    int sign(std::size_t side, std::size_t i, const Corner& c) const noexcept;

    std::array<std::vector<Corner>, 2> of_;  // counterclockwise or clockwise
    std::array<std::size_t, 2> axes_{};      // the two coordinates that are kept
    exact::Point w_{};
    double eta_ = 0;
};

}  // namespace ecods::convex
