// Bounds the rounding errors of sums of products of vertices, for two convex solids that share a point, or nearly do.
//
// Rounded points are relative to the first solid's translation (convex/posed_hulls.hpp). A coordinate is off by delta,
// and u' = 2^-52 bounds one operation. Let all coordinates of points be at most V, and all coordinates of differences m
// = p - q at most E. Then
//
//     m as computed                  e_m = 2 delta + u' E
//     an edge x = m1 - m0            e_x = 2 e_m + u' 2E           = 4 delta + 4 u' E
//     a coordinate of x * y          e_n = 17/4 u' X Y + 2 e_x (X + Y + e_x), where coordinates are at most X and Y
//     (two products of two roundings each, see exact/sign/filter_bound.hpp)
//     n . m, n off by e_n            e_h = 3 e_n E + |n| (2 delta + 4.1 u' E)
//
// where |n| is the sum of the magnitudes of n's coordinates. A factor of 1 + 2^-20 covers terms of higher order and the
// roundings of the bounds themselves.
//
// E is computed from size(): no two rounded points of a solid are further apart on an axis than size(), which includes
// four delta. So the points of a solid are at most half of size(), and delta, from its center, which is the middle of a
// box of the mesh.
//
// Reach is the greatest height of the true difference along n. Reach is computed from vertices p and q that support()
// found. A height in the mesh's coordinates is off by less than 1.5 delta |n| (PosedHulls::heights), so the highest
// vertex is less than 3 delta |n| above p. The rounded point of p is off by delta |n| along n, the product of this
// point and n by 3.1 u' V |n|, and 4.25 u' V <= delta: together less than 4.8 delta |n| for each solid. The difference
// of the products and the sum with the bound round by less than delta |n| more: 12 delta |n| covers all of this.
//
// Underflow loses less than 2^-1000 altogether. As delta is at least 2^-200, and E between delta and 2^200, a bound of
// 2^-800 covers it. Scenes beyond these limits are left to integers.
// Claim: verify/proofs/hull_signs.py
#pragma once

#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::depths {

struct RoundedBounds {
    double delta = 0, E = 0;
    double e_x = 0;

    RoundedBounds() = default;
    explicit RoundedBounds(const convex::PosedHulls& hulls) noexcept
        : delta(hulls.delta()),
          E(slack * (exact::largest(exact::minus(hulls.center(0), hulls.center(1))) +
                     0.5 * (hulls.size(0) + hulls.size(1)) + 2 * delta)),
          e_x(slack * (4 * delta + 4 * two_u * E)) {}

    // Returns true if the bounds hold. Comparisons with a NaN are false, so a NaN makes the result false.
    bool hold() const noexcept { return delta >= 0x1p-200 && delta <= E && E <= 0x1p200; }

    double of_normal(double X, double Y) const noexcept {
        return slack * (4.25 * two_u * (X * Y) + 2 * e_x * ((X + Y) + e_x)) + 0x1p-800;
    }
    double of_height(double e_n, double n_sum) const noexcept {
        return slack * (3 * e_n * E + n_sum * (2 * delta + 4.1 * two_u * E));
    }
    double of_reach(double n_sum) const noexcept { return 12 * delta * n_sum + 0x1p-800; }

    static constexpr double slack = 1 + 0x1p-20;
};

}  // namespace ecods::depths
