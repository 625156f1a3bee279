// Points are posed in doubles, in a common coordinate system, with a proven error bound.
//
// One operation, in any rounding mode, has fl(a op b) = (a op b)(1 + e), |e| <= u' = 2^-52, unless it underflows. (u'
// is `two_u` in code: twice the unit roundoff u = 2^-53.) Fused multiply-add removes a rounding, so all bounds remain
// true.
//
// A posed point is p = fl(R v + d), with the sum in the order ((r0 v0 + r1 v1) + r2 v2) + d, where d = fl(t - t0) is a
// rounded difference of translations. Each term has at most four factors (1 + e), so
//     |p - (R v + t - t0)| <= ((1 + u')^4 - 1) S <= (17/4) u' S,   S = sum |r_j||v_j| + |t - t0|.
// (verify/proofs/posed_point.g.) The sum S is itself computed, and too low by at most a factor of (1 - u')^4. In place
// of (t - t0), d is used, which is right up to a factor of 1 + u'. ((1 + u')^4 - 1) (1 - u')^-5 < 4.0001 u', so 17/4 in
// place of 4 covers both. An absolute term covers underflow (point_error_bound).
// Claim: verify/proofs/posed_point.g
// Claim: verify/proofs/point_error_bound.py
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/arithmetic.hpp"
#include "ecods/pose.hpp"

namespace ecods::exact {

using Point = std::array<double, 3>;

// Points<N> holds points of any bodies, relative to one origin and in one unit.
template <std::size_t N>
using Points = std::array<Point, N>;

// Returns fl(R v + d), in the order of operations that point_error_bound assumes.
inline Point pose_point(const Mat3& R, const Vec3& v, const Vec3& d) noexcept {
    Point p;
    for (int row = 0; row < 3; ++row) {
        p[static_cast<std::size_t>(row)] = ((R(row, 0) * v[0] + R(row, 1) * v[1]) + R(row, 2) * v[2]) + d[row];
    }
    return p;
}

// Returns an upper bound of the error of fl(R v + d) on any axis. sum_max is the largest sum S on any axis, and
// factor_max the largest magnitude of the factors R_ij and v_j.
//
// The absolute term covers underflow. A product or sum that underflows, gradually or to zero, loses at most 2^-1022;
// there are eight such operations. A subnormal input that the processor takes for zero changes a product by less than
// 2^-1022 times the other factor f; there are three products, and one d. If f < 2^19, the sum of all these is below
// 2^-1001; for larger f it is below 2^-1000 f.
inline constexpr double error_of_sum = 4.25 * two_u, underflow_of_points = 0x1p-1000, small_factor = 0x1p19;
inline double point_error_bound(double sum_max, double factor_max) noexcept {
    const double underflow =
        factor_max < small_factor ? underflow_of_points : underflow_of_points + underflow_of_points * factor_max;
    return error_of_sum * sum_max + underflow;
}
// Returns an upper bound of the error for all points v with |v_j| <= v_max_j.
inline double point_error_bound(const Mat3& R, const Vec3& v_max, const Vec3& d) noexcept {
    const double sum_max = (R.cwiseAbs() * v_max + d.cwiseAbs()).maxCoeff();
    const double factor_max = std::max(R.cwiseAbs().maxCoeff(), v_max.maxCoeff());
    return point_error_bound(sum_max, factor_max);
}

}  // namespace ecods::exact
