// PolygonOrder sorts the corners of a convex polygon by their order around the polygon.
//
// The corners are first sorted lexicographically. The first and the last corner are then the ends of a diagonal. The
// other corners are on the two sides of the diagonal, and on each side they are already in the order in which they
// follow each other. The side of a corner is the sign of an orientation, in homogeneous coordinates, in a plane of two
// coordinates. The plane is chosen such that the polygon's projection has an area.
//
// Widths. Numerators are below 2^(5k + 4) and denominators below 2^(4k + 4) (closest_points.hpp), so the determinant, a
// sum of six products of two numerators and a denominator, is below 2^(14k + 15), and has a sign.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/shared_corners.hpp"
#include "exact/measure/round/limb_vectors.hpp"

namespace ecods::exact {

template <int L>
class PolygonOrder {
  public:
    using Corner = typename SharedCorners<L>::Corner;

    // Chooses the plane of projection from `normal`, a normal of the polygon's plane, which must not be zero.
    explicit PolygonOrder(const LimbVector<2 * L>& normal) noexcept {
        std::size_t axis = 0;
        while (is_zero<2 * L>(normal[axis].limbs)) ++axis;
        turn_ = sign<2 * L>(normal[axis]);
        x_ = (axis + 1) % 3;
        y_ = (axis + 2) % 3;
    }

    // Sorts at least three corners, which must be in lexicographic order. The first corner stays the first; the others
    // follow counterclockwise, as seen from the side to which the normal points.
    void sort(std::vector<Corner>& corners) const {
        const Corner first = corners.front(), last = corners.back();
        const auto upper = std::stable_partition(corners.begin() + 1, corners.end() - 1, [&](const Corner& corner) {
            return turn_ * orientation(first, last, corner) < 0;
        });
        // The sorted list has the first corner, the lower side, the last corner, and the upper side in reverse order.
        std::reverse(upper, corners.end());
    }

  private:
    static constexpr int k = ExactFeatures<L>::coordinate_bits + 1;
    static_assert(14 * k + 16 <= 64 * (14 * L));

    // Returns the sign of the orientation of p, q and r: positive for a left turn. Not inlined, because sort() would
    // contain many copies of it (200 kB of code).
    [[gnu::noinline]] int orientation(const Corner& p, const Corner& q, const Corner& r) const noexcept {
        Limbs<14 * L> sum{};
        add_cofactor(sum, p, q, r);
        add_cofactor(sum, q, r, p);
        add_cofactor(sum, r, p, q);
        return sign<14 * L>(sum);
    }

    // Adds (p_x q_y - p_y q_x) times the denominator of r to `sum`.
    void add_cofactor(Limbs<14 * L>& sum, const Corner& p, const Corner& q, const Corner& r) const noexcept {
        Limbs<10 * L> minor{};
        add_product<5 * L, 5 * L>(minor, p.num[x_], q.num[y_]);
        add_product<5 * L, 5 * L>(minor, p.num[y_], q.num[x_], all_ones);
        add_product<10 * L, 4 * L>(sum, magnitude<10 * L>(minor), Magnitude<4 * L>{r.den, 0});
    }

    std::size_t x_, y_;
    int turn_;
};

// Returns the shared corners in their order around the polygon, counterclockwise as seen from the side to which the
// first triangle's normal points.
template <int L>
std::vector<typename SharedCorners<L>::Corner> corners_around(const SharedCorners<L>& shared) {
    auto corners = shared.corners();
    if (corners.size() > 2) PolygonOrder<L>(*shared.normal()).sort(corners);
    return corners;
}

}  // namespace ecods::exact
