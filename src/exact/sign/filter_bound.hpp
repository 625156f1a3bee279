// Bounds of the floating-point filter, as formulas in u = 2^-53, with their derivation.
//
// One operation, in any rounding mode: fl(a op b) = (a op b)(1 + e), |e| <= u' = 2u = 2^-52, unless it underflows.
// Fused multiply-add leaves an error out; the bounds stay. Flush-to-zero and underflow are the business of the absolute
// terms below. Overflow and NaN make a bound infinite or a comparison false, and the question goes to integers.
//
// Points. p = fl(R v + d) with the sum taken in the order ((r0 v0 + r1 v1) + r2 v2) + d, where d = fl(t - t0) is a
// rounded difference of translations. Each term meets at most four factors (1 + e), so
//     |p - (R v + t - t0)| <= ((1 + u')^4 - 1) S <= (17/4) u' S,   S = sum |r_j||v_j| + |t - t0|.
// (verify/proofs/posed_point.g.) The sum S is itself computed, low by a factor of no more than (1 - u')^4, and (t - t0)
// is known as d to a factor of 1 + u': ((1 + u')^4 - 1) (1 - u')^-5 < 4.0001 u', so the slack of 17/4 over 4 covers it.
// Underflow is covered by an absolute term, derived at point_error_bound.
//
// Differences. x = fl(p - q) of two such points, on an axis on which |p - q| <= ext (rounded points, exact difference):
//     |x - exact| <= e = u' ext + 2 delta,    |x|, |exact| <= E = ext + e.
//
// Determinant of three differences, computed as a normal (three 2x2 minors) and a dot product. Two sources of error.
// (1) Rounding, for differences as computed: every product of three factors meets at most five roundings; the
//     proof bounds the sum over the six products of magnitude up to Ex Ey Ez: 28.125 u' Ex Ey Ez
//     (verify/proofs/orient3d.g; stated there for u' and here as 30 u', which also absorbs the
//     rounding of the bound's own evaluation).
// (2) Input error, telescoped: det(X) - det(x) for |X - x| <= e changes one factor at a time; each of the six products
//     changes by at most ex Ey Ez + Ex ey Ez + Ex Ey ez: in sum 6 (ex Ey Ez + Ex ey Ez + Ex Ey ez).
// B3 = (30 u' Ex Ey Ez + 6 (...)) (1 + 2^-20). Half of the last factor's 2^-20 covers all roundings in the evaluation
// of ext, e, E and B3 (fewer than 40, each 2^-52); the other half covers underflow, see the range guard.
//
// The minor of two differences on axes i and j: rounding (17/4) u' Ei Ej (verify/proofs/orient2d.g: two products of
// two roundings each), input error 2 (ei Ej + Ei ej).
//
// Range guard. E < 2^200 keeps every product below 2^602: no overflow. Underflow in the determinant, gradual or to
// zero, loses at most 2^-1022 in each of six inner products, times a third factor below 2^200, and 2^-1022 in each of
// the other operations: in sum below 2^-818. B > 2^-780 makes half of the slack, B 2^-21 > 2^-801, larger. If the guard
// fails, the bound is infinite and the question goes to integers. (Underflow of a difference is below 2^-1022, and
// within what delta leaves over.)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "ecods/pose.hpp"

namespace ecods::exact {

inline constexpr double infinite_bound = std::numeric_limits<double>::infinity();

// Per axis: the error of a rounded difference, and the magnitude of differences.
struct DifferenceBound {
    std::array<double, 3> error;
    std::array<double, 3> magnitude;
};

// `extent`: on each axis, the largest difference of the rounded points. `delta`: the error of a point's coordinate.
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

// |det3 as computed - exact determinant| <= the result.
inline double orient3d_bound(const DifferenceBound& d) noexcept {
    const auto& e = d.error;
    const auto& E = d.magnitude;
    const double yz = E[1] * E[2], xz = E[0] * E[2], xy = E[0] * E[1];
    const double bound = (30 * two_u * (E[0] * yz) + 6 * (e[0] * yz + e[1] * xz + e[2] * xy)) * evaluation_slack;
    return is_in_range(d, bound) ? bound : infinite_bound;
}

// |minor on axes i, j as computed - exact minor| <= the result.
inline double orient2d_bound(const DifferenceBound& d, std::size_t i, std::size_t j) noexcept {
    const auto& e = d.error;
    const auto& E = d.magnitude;
    const double bound = (4.25 * two_u * (E[i] * E[j]) + 2 * (e[i] * E[j] + E[i] * e[j])) * evaluation_slack;
    return is_in_range(d, bound) ? bound : infinite_bound;
}

// The error of fl(R v + d) on any axis, for |v_j| <= v_max_j.
//
// The absolute term covers underflow. A product or sum that underflows, gradually or to zero, loses at most 2^-1022;
// there are eight. A subnormal input that the processor takes for zero changes a product by less than 2^-1022 times the
// other factor f; there are three, and one d. With f < 2^19 that is in sum below 2^-1001; for larger f, below 2^-1000
// f.
//
// From the largest sum on any axis, and the largest magnitude of the factors R_ij and v_j.
inline double point_error_bound(double sum_max, double factor_max) noexcept {
    const double underflow = factor_max < 0x1p19 ? 0x1p-1000 : 0x1p-1000 + 0x1p-1000 * factor_max;
    return 4.25 * two_u * sum_max + underflow;
}
inline double point_error_bound(const Mat3& R, const Vec3& v_max, const Vec3& d) noexcept {
    const double sum_max = (R.cwiseAbs() * v_max + d.cwiseAbs()).maxCoeff();
    const double factor_max = std::max(R.cwiseAbs().maxCoeff(), v_max.maxCoeff());
    return point_error_bound(sum_max, factor_max);
}

}  // namespace ecods::exact
