// This file derives the error bounds of the floating-point filter.
//
// Roundings and points are as in exact/point/point.hpp: u' = 2^-52 bounds one operation in any rounding mode, and delta
// is an upper bound of the error of a point's coordinate. After overflow or with NaN, a bound is infinite or a
// comparison is false. Then integers decide the sign.
//
// Differences. Let x = fl(p - q) for two rounded points, on an axis on which |p - q| <= ext (the exact difference of
// the rounded points). Then
//     |x - exact| <= e = u' ext + 2 delta,    |x|, |exact| <= E = ext + e.
//
// A determinant of three differences is computed as a normal (three 2x2 minors) and a dot product. It has two sources
// of error.
// (1) Rounding, relative to the differences as computed. Every product of three factors has at most five roundings. The
// proof bounds the sum over the six products of magnitude up to Ex Ey Ez: 28.125 u' Ex Ey Ez
// (verify/proofs/orient3d.g). Here 30 u' is used, which also covers the rounding of the bound's own evaluation.
// (2) Input error. For |X - x| <= e, det(X) - det(x) is a sum of three changes of one factor each. Each of the six
// products changes by at most ex Ey Ez + Ex ey Ez + Ex Ey ez: all of them by 6 (ex Ey Ez + Ex ey Ez + Ex Ey ez).
// B3 = (30 u' Ex Ey Ez + 6 (...)) (1 + 2^-20). Half of the last factor's 2^-20 covers all roundings in the evaluation
// of ext, e, E and B3 (fewer than 40, each 2^-52); the other half covers underflow, see the range guard.
//
// Minors of two differences on axes i and j have a rounding error of (17/4) u' Ei Ej (verify/proofs/orient2d.g: two
// products of two roundings each) and an input error of 2 (ei Ej + Ei ej).
//
// Range guard. If E < 2^200, every product is below 2^602, so nothing overflows. Underflow in the determinant, gradual
// or to zero, loses at most 2^-1022 in each of six inner products, times a third factor below 2^200, and 2^-1022 in
// each of the other operations: in total less than 2^-818. If B > 2^-780, half of the slack, B 2^-21 > 2^-801, is
// larger than that. If either condition is false, the bound is infinite, and integers decide. (Underflow of a
// difference is below 2^-1022, and covered by the slack of delta.)
// Claim: verify/proofs/orient3d.g
// Claim: verify/proofs/orient2d.g
// Claim: verify/proofs/filter_bound.py
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

inline constexpr double infinite_bound = std::numeric_limits<double>::infinity();

// A DifferenceBound holds upper bounds, by axis, of the error of a rounded difference and of the magnitude of
// differences.
struct DifferenceBound {
    std::array<double, 3> error;
    std::array<double, 3> magnitude;
};

// own_delta is the error bound of coordinates that were not posed: it covers subnormal coordinates that the processor
// takes for zero.
inline constexpr double own_delta = 0x1p-1000;

// Returns the bounds of differences of points. `extent` is the largest difference of rounded points on each axis.
// `delta` is an upper bound of the error of a point's coordinate.
inline DifferenceBound difference_bound(const std::array<double, 3>& extent, double delta) noexcept {
    DifferenceBound bound;
    for (std::size_t k = 0; k < 3; ++k) {
        bound.error[k] = two_u * extent[k] + 2 * delta;
        bound.magnitude[k] = extent[k] + bound.error[k];
    }
    return bound;
}

inline constexpr double evaluation_slack = 1 + 0x1p-20;

inline bool is_in_range(const DifferenceBound& d, double bound) noexcept {
    return std::max({d.magnitude[0], d.magnitude[1], d.magnitude[2]}) < 0x1p200 && bound > 0x1p-780;
}

// Returns an upper bound of |determinant as computed - exact determinant| for orient3d.
inline double orient3d_bound(const DifferenceBound& d) noexcept {
    const auto& e = d.error;
    const auto& E = d.magnitude;
    const double yz = E[1] * E[2], xz = E[0] * E[2], xy = E[0] * E[1];
    const double bound = (30 * two_u * (E[0] * yz) + 6 * (e[0] * yz + e[1] * xz + e[2] * xy)) * evaluation_slack;
    return is_in_range(d, bound) ? bound : infinite_bound;
}

// Returns an upper bound of |minor as computed - exact minor| for orient2d, on axes i and j.
inline double orient2d_bound(const DifferenceBound& d, std::size_t i, std::size_t j) noexcept {
    const auto& e = d.error;
    const auto& E = d.magnitude;
    const double bound = (4.25 * two_u * (E[i] * E[j]) + 2 * (e[i] * E[j] + E[i] * e[j])) * evaluation_slack;
    return is_in_range(d, bound) ? bound : infinite_bound;
}

// DeterminantBounds holds error bounds of all determinants of some points.
struct DeterminantBounds {
    double orient3d;
    std::array<double, 3> orient2d;  // [axis]: for the projection along that axis
};

// Returns error bounds of all determinants of points. `extent` and `delta` are as in difference_bound().
inline DeterminantBounds determinant_bounds(const std::array<double, 3>& extent, double delta) noexcept {
    const DifferenceBound d = difference_bound(extent, delta);
    return {orient3d_bound(d), {orient2d_bound(d, 1, 2), orient2d_bound(d, 2, 0), orient2d_bound(d, 0, 1)}};
}

template <std::size_t N>
DeterminantBounds determinant_bounds(const Points<N>& points, double delta) noexcept {
    std::array<double, 3> extent;
    for (std::size_t k = 0; k < 3; ++k) {
        double min = points[0][k], max = points[0][k];
        for (std::size_t i = 1; i < N; ++i) {
            min = std::min(min, points[i][k]);
            max = std::max(max, points[i][k]);
        }
        extent[k] = max - min;
    }
    return determinant_bounds(extent, delta);
}

}  // namespace ecods::exact
