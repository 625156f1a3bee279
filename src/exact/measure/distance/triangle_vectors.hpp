// The vectors between the corners of two triangles, and what any vector proves by its products with them.
//
// Let p be a corner of the first triangle and q one of the second, w = q - p, and a1, a2 and b1, b2 the other corners
// of either triangle less p and q. Every vector is a ScaledVector: it is counted in its own power of two. Coordinates
// are integers of magnitude at most X = 2^53, and off by at most
//     eta = 1 + error <= 6:
// one for the shift, `error` for the points, whose unit is at most the vector's. u' = 2^-52 bounds one operation.
//
// Weak duality. For ANY vector n, of doubles taken as they are, every point of the second triangle less every point of
// the first has at least the product min(0, n.b1, n.b2) + n.w - max(0, n.a1, n.a2) with n. No error of n matters. A
// product n.x as computed, three products and two sums, meets at most three factors (1 + e):
//     |fl(n.x) - n.x_true| <= ((1 + u')^3 - 1) X |n|_1 + eta |n|_1 <= (6.01 + eta) |n|_1,   u' X = 2.
// Subtracting a bound from it, or adding one, rounds by up to u' (X |n|_1 + the bound) < 2.01 |n|_1. |n|_1 as computed
// is low by (1 - u')^2 at most. So E = (8.5 + eta) times it, subtracted or added, leaves a bound of the true product.
// Let r1 = n.w - E, r2 = r1 + min, r3 = r2 - max as computed, brought to the power of two of w, which is exact. The
// last two round by u' of their results, and r3 <= r2 <= r1, so the sum is at least r3 - 4 u' r1.
//
// Certain signs. A vector is off by C u' X in each coordinate, C = eta / 2. A polynomial of m monomials of degree g in
// vectors, evaluated with at most r roundings on the way of any monomial, is off by at most m (g C + r) u' times the
// product of the X: a monomial meets at most (1 + C u')^g (1 + u')^r, and 2^-20 more (second_order) covers the second
// order and the bound's own arithmetic. A difference of two such numbers in one power of two has the sum of the bounds,
// and twice that covers its rounding. All numbers are 0 or between 2^-200 and 2^600: nothing underflows or overflows.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// X^2, X^3, and what covers the second order of a bound.
inline constexpr double square_of_size = 0x1p106;
inline constexpr double cube_of_size = 0x1p159;
inline constexpr double second_order = 1 + 0x1p-20;

struct TriangleVectors {
    TriangleVectors(const IntegerPair& pair, std::size_t p, std::size_t q) noexcept {
        const auto at = [&](std::size_t side, std::size_t i) -> const IntegerVector& {
            return pair.at[3 * side + i % 3];
        };
        const bool is_exact = pair.error == 0;
        w = scaled(difference(at(1, q), at(0, p)), is_exact);
        for (std::size_t k = 0; k < 2; ++k) {
            other[0][k] = scaled(difference(at(0, p + k + 1), at(0, p)), is_exact);
            other[1][k] = scaled(difference(at(1, q + k + 1), at(1, q)), is_exact);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t k = 0; k < 2; ++k) factor[side][k] = power_of_two(other[side][k].shift - w.shift);
        }
        eta = 1 + pair.error;
    }

    // E, for a product with n.
    double product_error(const Point& n) const noexcept {
        return (8.5 + eta) * ((std::abs(n[0]) + std::abs(n[1])) + std::abs(n[2]));
    }

    // A lower bound of the product of n with any point of the second triangle less any of the first, in units of w,
    // where it is positive.
    ECODS_ALWAYS_INLINE double gap(const Point& n, double error) const noexcept {
        const double first = dot(n, w.x) - error;
        double low = 0, high = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            low = std::min(low, (dot(n, other[1][k].x) - error) * factor[1][k]);
            high = std::max(high, (dot(n, other[0][k].x) + error) * factor[0][k]);
        }
        return ((first + low) - high) - 4 * two_u * first;
    }

    // Whether the corner `other[side][k]` is certainly on its own triangle's side of the plane through p or q at right
    // angles to n, for a bound of the product.
    bool is_outward(const Point& n, std::size_t side, std::size_t k, double bound) const noexcept {
        const double x = dot(n, other[side][k].x);
        return side == 0 ? x < -bound : x > bound;
    }

    ScaledVector w;
    ScaledVector other[2][2];
    double factor[2][2];  // powers of two: from the unit of a vector to that of w
    double eta;
};

}  // namespace ecods::exact
