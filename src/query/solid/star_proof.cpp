#include "query/solid/star_proof.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "exact/sign/filter_bound.hpp"
#include "exact/sign/plain_signs.hpp"

// Theorem. Let o be a point that is on the plane of no triangle, such that
//   (1) every edge is a side of exactly two triangles, and their third corners are strictly on different sides of the
//       plane through o and the edge; and
//   (2) some half-line from o meets no edge, and exactly one triangle.
// Then no two triangles share a segment or more which is not a side of both, and no two different edges share a
// segment.
//
// Proof. Let P be the central projection from o onto a sphere around o. As o is off the plane of a triangle, P is one
// to one on the triangle, and maps its interior to an open set and its sides to arcs of great circles. For x on the
// sphere but on no arc, let N(x) be the number of triangles whose interiors have x in their image. N is constant where
// no arc is crossed. Let x be a point of arcs that is neither the end of an arc nor a point where arcs of two circles
// meet: these are all points of the arcs but for finitely many. All arcs through x lie along one circle. By (1) each of
// them is the side of one triangle on the one side of the circle and of one triangle on the other. Any other triangle
// with x in its image has x in the image of its interior. So N is the same on both sides of x. Finitely many points do
// not separate a sphere, so N is constant, and by (2) it is 1.
//
// So the images of the interiors of two triangles are disjoint: their common part would be open, and N would be 2 at a
// point of it. Let triangles S and T share a segment s. Suppose that P(s) had a point in the image of the interior of
// S. That image is open, so it would contain points of the image of the interior of T. So s is in the border of S,
// along a side, and likewise in the border of T. Let s be along sides that are not one edge, and let x be a point of
// P(s) of the kind above. The two triangles of S's edge fill both sides of the circle near x, and the image of T's
// interior fills one of these sides: T is one of the two triangles. But then T has two sides along one line, and no
// area. QED.
//
// The surface is connected over edges: a path on the sphere from one triangle to another can avoid the ends of arcs,
// and where it crosses an arc it goes to the other triangle of an edge. So the surface is one shell. By N = 1 every
// half-line from o meets it once. So o is inside, and for each triangle, the side on which o is, is the inner side.
//
// All signs are those of the filter: an uncertain sign proves nothing, and neither the choice of o nor its rounding can
// make the answer wrong. A point o near the middle only makes success likely for a convex body.

namespace ecods {
namespace {

using namespace exact;

Point point_of(const Vec3& v) noexcept {
    return {v[0], v[1], v[2]};
}

enum class Hit { none, inside, unknown };

class StarProof {
  public:
    explicit StarProof(const ProperMesh& proper)
        : proper_(proper), triangles_(proper.mesh->triangles()), vertices_(proper.mesh->vertices()) {}

    bool find(const MeshEdges& edges) {
        if (!choose_origin() || !are_planes_off_origin()) return false;
        for (std::size_t i = 0; i < edges.count(); ++i) {
            if (!is_seen_between(edges.sides(i))) return false;
        }
        return std::ranges::any_of(std::array{0, 1, 2}, [&](int axis) { return is_met_once(axis); });
    }

    // Returns a list with an entry for each triangle: true if its corners turn right, seen from outside. Call this
    // function only after find() has returned true.
    std::vector<std::uint8_t> take_sides() noexcept { return std::move(is_above_); }

  private:
    template <class Visit>
    void visit_corners(Visit&& visit) const {
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (!proper_.is_proper(i)) continue;
            for (const std::uint32_t vertex : triangles_[i]) visit(point_of(vertices_[vertex]));
        }
    }

    // Sets the origin to a weighted mean of all corners. The weights have no pattern, because from the exact middle of
    // a box the half-lines along the axes would meet the diagonals of its faces. The error bounds hold for points in
    // the box around the corners, so the mean is clamped to this box, in case rounding moved it out. Returns false if
    // the bounds are infinite.
    bool choose_origin() {
        Point min, max, sum{};
        min.fill(std::numeric_limits<double>::infinity());
        max.fill(-std::numeric_limits<double>::infinity());
        constexpr double golden_part = 0.6180339887498949;
        double total = 0, part = 0;
        visit_corners([&](const Point& p) {
            part += golden_part;
            if (part >= 1) part -= 1;
            const double weight = 1 + part;
            total += weight;
            for (std::size_t k = 0; k < 3; ++k) {
                min[k] = std::min(min[k], p[k]);
                max[k] = std::max(max[k], p[k]);
                sum[k] += weight * p[k];
            }
        });
        if (total == 0) return false;
        std::array<double, 3> extent;
        for (std::size_t k = 0; k < 3; ++k) {
            origin_[k] = std::clamp(sum[k] / total, min[k], max[k]);
            extent[k] = max[k] - min[k];
        }
        bounds_ = determinant_bounds(extent, own_delta);
        return bounds_.orient3d < infinite_bound;
    }

    // Sets is_above_, by triangle, to the side of its plane on which the origin is. Returns false if a side is not
    // certain.
    bool are_planes_off_origin() {
        is_above_.assign(triangles_.size(), 0);
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (!proper_.is_proper(i)) continue;
            const auto [a, b, c] = corners(i);
            const int side = certain_sign(plain_orient3d(a, b, c, origin_), bounds_.orient3d);
            if (side == 0) return false;
            is_above_[i] = side > 0;
        }
        return true;
    }

    // Returns true if an edge with these sides fulfils condition (1). Consider the sign of orient3d(lesser vertex,
    // greater vertex, third corner, origin). If the side begins at its lesser vertex, this sign is that of
    // orient3d(triangle's corners, origin); otherwise it is the opposite one.
    bool is_seen_between(std::span<const SideRef> sides) const {
        if (sides.size() != 2) return false;
        const auto is_third_above = [&](const SideRef& side) {
            const Triangle& t = triangles_[side.triangle];
            return (t[side.corner] < t[(side.corner + 1) % 3]) == (is_above_[side.triangle] != 0);
        };
        return is_third_above(sides[0]) != is_third_above(sides[1]);
    }

    // Returns true if the half-line from the origin along an axis is proven to fulfil condition (2).
    bool is_met_once(int axis) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (!proper_.is_proper(i)) continue;
            const Hit hit = hit_of(i, axis);
            if (hit == Hit::unknown) return false;
            count += hit == Hit::inside ? 1 : 0;
        }
        return count == 1;
    }

    // Returns the Hit of the half-line along the axis: whether it meets the interior of triangle i. Projected along the
    // axis, the corners turn left or right by the sign of the normal's component n. If the line meets the interior at o
    // + t e, then t n is minus the height of o above the plane. So t > 0 if n and the height have different signs.
    Hit hit_of(std::size_t i, int axis) const {
        const auto t = corners(i);
        for (const int k : {(axis + 1) % 3, (axis + 2) % 3}) {
            const auto at = static_cast<std::size_t>(k);
            if (std::min({t[0][at], t[1][at], t[2][at]}) > origin_[at]) return Hit::none;
            if (std::max({t[0][at], t[1][at], t[2][at]}) < origin_[at]) return Hit::none;
        }
        const double bound = bounds_.orient2d[static_cast<std::size_t>(axis)];
        std::array<int, 3> turns;
        for (std::size_t k = 0; k < 3; ++k)
            turns[k] = certain_sign(plain_orient2d(t[k], t[(k + 1) % 3], origin_, axis), bound);
        const auto [least, most] = std::ranges::minmax(turns);
        if (least < 0 && most > 0) return Hit::none;
        if (least == 0 || most == 0) return Hit::unknown;
        return (most > 0) != (is_above_[i] != 0) ? Hit::inside : Hit::none;
    }

    std::array<Point, 3> corners(std::size_t i) const {
        const Triangle& t = triangles_[i];
        return {point_of(vertices_[t[0]]), point_of(vertices_[t[1]]), point_of(vertices_[t[2]])};
    }

    const ProperMesh& proper_;
    std::span<const Triangle> triangles_;
    std::span<const Vec3> vertices_;
    Point origin_{};
    DeterminantBounds bounds_{};
    std::vector<std::uint8_t> is_above_;  // by triangle: true if the origin is above its plane
};

}  // namespace

std::vector<std::uint8_t> prove_star(const ProperMesh& proper, const MeshEdges& edges) {
    StarProof proof(proper);
    return proof.find(edges) ? proof.take_sides() : std::vector<std::uint8_t>();
}

}  // namespace ecods
