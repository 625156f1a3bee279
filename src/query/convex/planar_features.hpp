// PlanarFeatures projects the features on which the closest, or deepest, points of two convex solids lie to polygons in
// one plane.
//
// All pairs of closest or deepest points differ by one vector w, from the first solid to the second. Both features are
// perpendicular to w, or to the normal of the depth if w is zero. So if the second feature is moved by -w, both are in
// one plane, and a pair of points becomes one point. The polygons are convex there. They stay convex if one coordinate
// is left out: the one in which the normal is largest. Then a few signs in the plane decide which pairs of features
// have a point in common.
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

#include "base/short_list.hpp"
#include "query/convex/hull_features.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

class PlanarFeatures {
  public:
    // Projects the features `parts` along `normal`, a unit vector perpendicular to both features, each coordinate
    // rounded once, and w is `along` times this vector, in the unit of rounded points. `along` is off by at most 2^-51
    // of its magnitude. If it is infinite, w is unknown, and all answers are open.
    PlanarFeatures(const PosedHulls& hulls, const std::array<HullFeature, 2>& parts, const Vec3& normal, double along);

    std::size_t vertex_count(std::size_t side) const noexcept { return of_[side].at.size(); }
    std::size_t edge_count(std::size_t side) const noexcept {
        return vertex_count(side) < 3 ? vertex_count(side) - 1 : vertex_count(side);
    }
    HullFeature vertex(std::size_t side, std::size_t i) const noexcept {
        return {Feature::Kind::vertex, of_[side].at[i].vertex};
    }
    // Returns the edge from vertex i to the next one.
    HullFeature edge(std::size_t side, std::size_t i) const noexcept {
        return {Feature::Kind::edge, of_[side].at[i].edge};
    }
    std::size_t next(std::size_t side, std::size_t i) const noexcept { return i + 1 == vertex_count(side) ? 0 : i + 1; }

    // Calls visit(i, j) for all vertices i of the first polygon and j of the second, unless the two are certainly
    // apart.
    template <class Visit>
    void visit_meeting(Visit&& visit) const {
        for (std::size_t i = 0; i < vertex_count(0); ++i) {
            if (!may_be_on_border(0, i)) continue;
            for (std::size_t j = 0; j < vertex_count(1); ++j) {
                if (may_be_on_border(1, j) && may_meet(i, j)) visit(i, j);
            }
        }
    }
    // Calls visit(i, j) for all vertices i of polygon `side` and edges j of the other polygon, unless the vertex is
    // certainly not on the edge. Goes on with the next vertex if visit() returns true.
    template <class Visit>
    void visit_on_edges(std::size_t side, Visit&& visit) const {
        for (std::size_t i = 0; i < vertex_count(side); ++i) {
            if (!may_be_on_border(side, i)) continue;
            for (std::size_t j = 0; j < edge_count(1 - side); ++j) {
                if (sign(1 - side, j, i) == 0 && may_be_on(side, i, j) && visit(i, j)) break;
            }
        }
    }

    // Returns the coordinate that is left out.
    std::size_t dropped_axis() const noexcept { return 3 - axes_[0] - axes_[1]; }

    enum class Answer : std::uint8_t { no, yes, open };
    // Returns `yes` if vertex i of polygon `side` is inside the other polygon, which must be a face; `no` if not;
    // `open` if doubles do not decide. Uses that a point outside a convex polygon is on the inner side of some edge and
    // on the outer side of another.
    Answer is_inside(std::size_t side, std::size_t i) const noexcept {
        const std::uint8_t sides = of_[side].sides[i];
        return (sides & on_both) == on_both ? Answer::no : (sides & on_line) != 0 ? Answer::open : Answer::yes;
    }
    // Returns `yes` if edge i of the first polygon and edge j of the second cross in their interiors; `no` if not;
    // `open` if doubles do not decide. Uses that two segments cross if each has its ends on both sides of the other
    // one's line.
    Answer do_cross(std::size_t i, std::size_t j) const noexcept {
        const int a = sign(0, i, j) * sign(0, i, next(1, j)), b = sign(1, j, i) * sign(1, j, next(0, i));
        if (a > 0 || b > 0) return Answer::no;
        return a < 0 && b < 0 ? Answer::yes : may_cross(i, j) ? Answer::open : Answer::no;
    }

  private:
    static constexpr std::size_t short_size = 32;
    // on_left and on_right are bits for the sides of the other polygon's edges on which a vertex is; on_line is set if
    // one side is not certain.
    static constexpr std::uint8_t on_line = 1, on_left = 2, on_right = 4, on_both = on_left | on_right;

    // A Projected holds the vertices of a polygon, counterclockwise or clockwise, with the edges that begin at them.
    struct Projected {
        ShortList<Hull::Neighbor, short_size> at;
        ShortList<double, short_size> x, y;
        ShortList<std::uint8_t, short_size> sides;
        // `signs` has, at [i m + j], the side of edge i on which vertex j of the other polygon is, as a sign; 0 if the
        // side is not certain. The other polygon has m vertices.
        ShortList<std::int8_t, 8 * short_size> signs;
    };

    void add(const PosedHulls& hulls, std::size_t side, std::uint32_t vertex, std::uint32_t edge);
    void set_signs(std::size_t side);
    int sign(std::size_t side, std::size_t i, std::size_t j) const noexcept {
        return of_[side].signs[i * vertex_count(1 - side) + j];
    }
    // Returns false if vertex i of polygon `side` is certainly on no edge of the other polygon.
    bool may_be_on_border(std::size_t side, std::size_t i) const noexcept {
        return edge_count(1 - side) == 0 || (of_[side].sides[i] & on_line) != 0;
    }
    bool may_meet(std::size_t i, std::size_t j) const noexcept;
    bool may_be_on(std::size_t side, std::size_t i, std::size_t j) const noexcept;
    bool may_cross(std::size_t i, std::size_t j) const noexcept;
    // Returns true if two boxes are certainly apart: the box around vertices a and b of polygon `side`, and the box
    // around vertices c and d of the other polygon.
    bool are_apart(std::size_t side, std::size_t a, std::size_t b, std::size_t c, std::size_t d) const noexcept;

    std::array<Projected, 2> of_;
    std::array<std::size_t, 2> axes_{};  // the two coordinates that are kept
    exact::Point w_{};
    double eta_ = 0;
};

}  // namespace ecods::convex
