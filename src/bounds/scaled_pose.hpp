// A ScaledPose is a pose in units in which nothing overflows, and little is lost to underflow. A ScaledPose serves to
// compute the boxes of bodies whose coordinates are very large or very small.
//
// Coordinate i of a point v is sum_j R_ij v_j + t_i. This coordinate is computed times 2^-e, from R_ij 2^(c_j - e), v_j
// 2^-c_j and t_i 2^-e. c_j is chosen such that all |v_j| < 2^c_j, and e is the least exponent such that all |R_ij|
// 2^c_j and |t_i| are below 2^e. So all these numbers are below 1, and the largest sum of magnitudes is 1/4 or more.
// Scaling changes exponents by bits. The scaling is exact except for results below 2^-1022, which become zero; with
// factors below 1 the nine products lose less than 2^-1018, which is below 2^-10 of the term for underflow in
// point_error_bound.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "exact/number/power.hpp"

namespace ecods {

// A pose need not be scaled if point_error_bound exceeds unscaled_min (1 + factor_max): then its term for underflow is
// less than 2^-9 of the whole bound.
inline constexpr double unscaled_min = 0x1p-990;

class ScaledPose {
  public:
    // Makes a scaled pose for points v with |v_j| <= v_max_j. If scales_points is false, v_max affects only e: then
    // points are not scaled (all c_j are zero in the formulas above).
    ScaledPose(const Pose& pose, const Vec3& v_max, bool scales_points) noexcept {
        std::array<int, 3> above{};
        for (std::size_t j = 0; j < 3; ++j) above[j] = exact::exponent_above(v_max[static_cast<Eigen::Index>(j)]);
        for (int i = 0; i < 3; ++i) {
            exponent_ = std::max(exponent_, exact::exponent_above(pose.t[i]));
            for (int j = 0; j < 3; ++j) {
                const int product = exact::exponent_above(pose.R(i, j)) + above[static_cast<std::size_t>(j)];
                exponent_ = std::max(exponent_, product);
            }
        }
        pose_.R.setZero();
        if (is_zero()) return;
        for (std::size_t j = 0; j < 3; ++j) {
            if (above[j] == none) continue;
            points_[j] = scales_points ? above[j] : 0;
            const auto column = static_cast<Eigen::Index>(j);
            for (int i = 0; i < 3; ++i)
                pose_.R(i, column) = exact::times_power(pose.R(i, column), points_[j] - exponent_);
        }
        for (int i = 0; i < 3; ++i) pose_.t[i] = exact::times_power(pose.t[i], -exponent_);
    }

    // Returns true if every posed point is the origin.
    bool is_zero() const noexcept { return exponent_ < none / 2; }

    const Pose& pose() const noexcept { return pose_; }

    Vec3 point(const Vec3& v) const noexcept {
        return {exact::times_power(v[0], -points_[0]), exact::times_power(v[1], -points_[1]),
                exact::times_power(v[2], -points_[2])};
    }

    // Returns the least box of doubles that contains a box of scaled points. An end is infinite only if it is beyond
    // the largest double.
    Aabb unscaled(const Aabb& box) const noexcept {
        Aabb result;
        for (int k = 0; k < 3; ++k) {
            result.min[k] = -exact::times_power_above(-box.min[k], exponent_);
            result.max[k] = exact::times_power_above(box.max[k], exponent_);
        }
        return result;
    }

  private:
    static constexpr int none = exact::exponent_of_zero;

    Pose pose_;
    std::array<int, 3> points_{};  // c_j
    int exponent_ = none;          // e
};

}  // namespace ecods
