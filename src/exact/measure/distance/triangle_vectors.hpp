// TriangleVectors computes vectors between the corners of two triangles, products of these vectors, and error bounds of
// the products.
//
// Let p be a corner of the first triangle, q a corner of the second, and w = q - p. Let a1 and a2 be the first
// triangle's other corners minus p, and b1 and b2 the second triangle's other corners minus q. Each of these vectors is
// a ScaledVector, with its own power of two. Coordinates are integers of magnitude at most X = 2^53, and off by at most
//     eta = 1 + error <= 6:
// one for the shift, and `error` for the points, whose unit is at most the vector's. u' = 2^-52 bounds the relative
// error of one operation.
//
// Weak duality. Let n be ANY vector of doubles. For every point x of the first triangle and y of the second, n.(y - x)
// is at least min(0, n.b1, n.b2) + n.w - max(0, n.a1, n.a2). n itself is taken as it is, so its errors do not matter. A
// product n.x as computed, three products and two sums, has at most three factors (1 + e) on each term:
//     |fl(n.x) - n.x_true| <= ((1 + u')^3 - 1) X |n|_1 + eta |n|_1 <= (6.01 + eta) |n|_1,   u' X = 2.
// Subtracting a bound from n.x, or adding one, rounds by up to u' (X |n|_1 + the bound) < 2.01 |n|_1. |n|_1 as computed
// is too low by at most a factor of (1 - u')^2. So n.x - E and n.x + E, with E = (8.5 + eta) |n|_1, are bounds of the
// true product. Let r1 = n.w - E, r2 = r1 + min, r3 = r2 - max as computed, where min and max are scaled to the power
// of two of w, which is exact. The last two sums round by u' of their results, and r3 <= r2 <= r1, so the true value is
// at least r3 - 4 u' r1.
//
// Certain signs. A vector is off by C u' X in each coordinate, C = eta / 2. Consider a polynomial of m monomials of
// degree g in the vectors, evaluated with at most r roundings of any monomial. It is off by at most m (g C + r) u'
// times the product of the X: a monomial has a factor of at most (1 + C u')^g (1 + u')^r, and 2^-20 more (second_order)
// covers the second order and the bound's own arithmetic. The difference of two such numbers in one power of two has
// the sum of their bounds, and twice that sum covers its rounding, too. All numbers are 0 or between 2^-200 and 2^600,
// so nothing underflows or overflows. The bounds, in units of u' times the product of the X, are
//     x.y                                  3 (2 C + 3)
//     (x x y).z                            6 (3 C + 5)
//     (x x y).(z x v)                     12 (4 C + 7)
//     ((y.y) x - (x.y) y).z               18 (4 C + 8)
//
// Feet. Let n = u x v, where u and v are a face's edges from its corner, or two edges. Let d be the vector along which
// features are projected: n itself, or the direction of a motion. Let f and g be the powers of two between the unit of
// w and the units of u and v. For a vertex and a face, let `foot` be the vector from the face's corner to the vertex,
// which is w or -w. The vertex is projected into the face at
//     s1 = (foot x v).d / (f n.d),  s2 = (u x foot).d / (g n.d),  inside if s1, s2 and 1 - s1 - s2 are positive,
// and two edges cross in the projection at
//     s1 = (w x v).d / (f n.d),     s2 = (w x u).d / (g n.d),     inside if these and 1 - s1, 1 - s2 are.
// The signs of s1 n.d and s2 n.d are certain by the bound of (x x y).d, which is the bound of (x x y).z for a motion
// and of (x x y).(z x v) for n. Sums of s1, s2 and 1 are treated like the differences above.
// Claim: verify/proofs/weak_duality.py
// Claim: verify/proofs/enclosure_signs.g
// Claim: verify/proofs/enclosure_signs_exact.g
// Claim: verify/proofs/certain_signs.py
#pragma once

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// square_of_size, cube_of_size and second_order are X^2, X^3, and the factor that covers the second order of a bound
// (see "Certain signs").
inline constexpr double square_of_size = 0x1p106;
inline constexpr double cube_of_size = 0x1p159;
inline constexpr double second_order = 1 + 0x1p-20;

struct TriangleVectors {
    // Feet holds the feet at s / den along the first vector and t / den along the second, with den >= 0. `are_inside`
    // is true if the feet are certainly inside both features.
    struct Feet {
        double s, t, den;
        bool are_inside;
    };

    // Computes the vectors for the corners p and q that name the features in f; for a face, p or q is its
    // blunt_corner().
    TriangleVectors(const IntegerPair& pair, const FeaturePair& f) noexcept {
        std::size_t p = f.a, q = f.b;
        if (f.kind == FeatureKind::vertex_face) (f.vertex_side == 0 ? q : p) = blunt_corner(pair, 1 - f.vertex_side);
        const auto at = [&](std::size_t side, std::size_t i) -> const IntegerVector& {
            return pair.at[3 * side + i % 3];
        };
        const bool is_exact = pair.error == 0;
        w = scaled(difference(at(1, q), at(0, p)), is_exact);
        is_point = pair.first_is_point;
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t corner = side == 0 ? p : q;
            for (std::size_t k = 0; k < 2; ++k) {
                if (side == 0 && is_point) {
                    other[side][k] = {{0, 0, 0}, w.shift};
                } else {
                    other[side][k] = scaled(difference(at(side, corner + k + 1), at(side, corner)), is_exact);
                }
                factor[side][k] = power_of_two(other[side][k].shift - w.shift);
            }
        }
        eta = 1 + pair.error;
    }

    // Return the bounds of the table under "Certain signs", with C = eta / 2, row by row.
    double bound_of_two() const noexcept { return 3 * (eta + 3) * two_u * square_of_size * second_order; }
    double bound_of_three() const noexcept { return 6 * (1.5 * eta + 5) * two_u * cube_of_size * second_order; }
    double bound_of_four() const noexcept {
        return 12 * (2 * eta + 7) * two_u * (square_of_size * square_of_size) * second_order;
    }
    double bound_across() const noexcept {
        return 18 * (2 * eta + 8) * two_u * (square_of_size * square_of_size) * second_order;
    }

    // Returns E, the error bound of a dot product with n.
    double product_error(const Point& n) const noexcept { return (8.5 + eta) * sum_of_magnitudes(n); }

    // Returns a lower bound of n.(y - x) over all points x of the first and y of the second triangle, in units of w.
    // `error` is product_error(n). A result that is not positive proves nothing.
    ECODS_ALWAYS_INLINE double gap(const Point& n, double error) const noexcept {
        const double first = dot(n, w.x) - error;
        double low = 0, high = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            low = std::min(low, (dot(n, other[1][k].x) - error) * factor[1][k]);
            if (!is_point) high = std::max(high, (dot(n, other[0][k].x) + error) * factor[0][k]);
        }
        return ((first + low) - high) - 4 * two_u * first;
    }

    // Returns true if it is certain that the corner at the end of other[side][k] is on its own triangle's side of the
    // plane through p or q perpendicular to n. `bound` is an upper bound of the dot product's error. A point has no
    // other corners.
    bool is_outward(const Point& n, std::size_t side, std::size_t k, double bound) const noexcept {
        if (side == 0 && is_point) return true;
        const double x = dot(n, other[side][k].x);
        return side == 0 ? x < -bound : x > bound;
    }

    // The next functions are for a vertex and a face, or two edges. first_edge(), second_edge() and normal() return u,
    // v and n of the section "Feet". feet() returns the feet in the projection along `along`, with `bound` as the bound
    // of signs. are_others_outward() is true if all corners beside the features are certainly outward.
    const Point& first_edge(const FeaturePair& f) const noexcept { return other[plane_side(f)][0].x; }
    const Point& second_edge(const FeaturePair& f) const noexcept {
        return f.kind == FeatureKind::edge_edge ? other[1][0].x : other[plane_side(f)][1].x;
    }
    Point normal(const FeaturePair& f) const noexcept { return cross(first_edge(f), second_edge(f)); }
    ECODS_ALWAYS_INLINE Feet feet(const FeaturePair& f, const Point& n, const Point& along,
                                  double bound) const noexcept {
        const Point &u = first_edge(f), &v = second_edge(f);
        const double n_along = dot(n, along), sign = n_along < 0 ? -1 : 1, den = std::abs(n_along);
        if (f.kind == FeatureKind::edge_edge) {
            const double s = sign * dot(cross(w.x, v), along), t = sign * dot(cross(w.x, u), along);
            const double a = factor[0][0], b = factor[1][0];
            return {s, t, den,
                    (s > bound) && (t > bound) && (den * a - s > bound * (1 + a) * 2) &&
                        (den * b - t > bound * (1 + b) * 2)};
        }
        const std::size_t of = plane_side(f);
        const Point foot = of == 1 ? negated(w.x) : w.x;
        const double s = sign * dot(cross(foot, v), along), t = sign * dot(cross(u, foot), along);
        const double a = factor[of][0], b = factor[of][1];
        return {s, t, den, (s > bound) && (t > bound) && ((den - s / a) - t / b > bound * (1 + 1 / a + 1 / b) * 2)};
    }
    bool are_others_outward(const FeaturePair& f, const Point& n, double bound) const noexcept {
        if (f.kind == FeatureKind::edge_edge) return is_outward(n, 0, 1, bound) && is_outward(n, 1, 1, bound);
        return is_outward(n, f.vertex_side, 0, bound) && is_outward(n, f.vertex_side, 1, bound);
    }

    ScaledVector w;
    ScaledVector other[2][2];
    double factor[2][2];  // powers of two: a number in the unit of other[][] times factor is in the unit of w
    double eta;
    bool is_point;  // true if the first triangle is a point: p, with no a1 and a2

  private:
    // Returns the triangle that has the edge u: the face's triangle, or the first one.
    static std::size_t plane_side(const FeaturePair& f) noexcept {
        return f.kind == FeatureKind::edge_edge ? 0 : 1 - f.vertex_side;
    }
};

}  // namespace ecods::exact
