// MovingCorners computes the corners of two moving triangles at any time in [0, 1], in doubles with an error bound.
//
// Bound. A corner at time s is computed as P (1 - s) + Q s from its rounded positions P and Q at times 0 and 1, which
// are off by e0 and e1. So the corner is off by e(s) = e0 (1 - s) + e1 s, plus 3.01 u' M(s) for the roundings: each
// product has three factors (1 + e), |e| <= u' = 2^-52. Here M(s) = M0 (1 - s) + M1 s, where M0 and M1 are the largest
// magnitudes on the axis at times 0 and 1. Before that, the reference point is subtracted, which adds u' M0 and u' M1
// to the errors of the positions; e0 and e1 include these. A dot product with a vector n has three more factors on each
// term: 3.01 u' |n| M(s). The difference of two such projections has twice this bound, and one more rounding, u' times
// 2 |n| M(s). Together this is 2 e(s) + 14.1 u' M(s) on each axis, times |n|. The bound 2.25 e(s) + 20 u' M(s) also
// covers its own rounding, and its interpolation between both ends. Subtracting the bound adds u' times a number that
// is at most 2 |n| M(s): covered, too.
//
// Underflow. All numbers are scaled by a power of two, to magnitudes below 2. The scaling is exact except for results
// below 2^-1022. Numbers below 2^-1022 before scaling are less than 2^-22 of e0 and e1, which are 2^-1000 or more.
// Vectors n are products of three differences at most: below 2^8. An operation that underflows, or a time that is taken
// for zero, loses 2^-1022 times such factors. A hundred such losses are below 2^-1000, and 2^-990 is added to the
// bound.
// Claim: verify/proofs/moving_points.py
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "exact/point/point.hpp"
#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// MovingPoints holds the rounded corners of both triangles at times 0 and 1, and upper bounds of the errors of the
// corners on any axis.
struct MovingPoints {
    Points<6> start, end;
    double start_error, end_error;
};

// TimeSpan is the interval of time [from, to], inside [0, 1].
struct TimeSpan {
    double from, to;
};

// MovingCorners computes corners that move straight, relative to the first corner at time 0, because the others are
// near it.
class MovingCorners {
  public:
    static constexpr double underflow = 0x1p-990;

    ECODS_ALWAYS_INLINE explicit MovingCorners(const MovingPoints& points) noexcept {
        const Point origin = points.start[0];
        double most_before = std::max(points.start_error, points.end_error), size = 0;
        Point most_at_start{}, most_at_end{};
        for (std::size_t k = 0; k < 3; ++k) {
            most_before = std::max(most_before, std::abs(origin[k]));
            for (std::size_t i = 0; i < 6; ++i) {
                most_before = std::max({most_before, std::abs(points.start[i][k]), std::abs(points.end[i][k])});
                start_[i][k] = points.start[i][k] - origin[k];
                end_[i][k] = points.end[i][k] - origin[k];
                most_at_start[k] = std::max(most_at_start[k], std::abs(start_[i][k]));
                most_at_end[k] = std::max(most_at_end[k], std::abs(end_[i][k]));
            }
            size = std::max({size, most_at_start[k], most_at_end[k]});
        }
        is_bounded_ = most_before < 0x1p1000;
        const double scale = inverse_power(size);
        for (std::size_t k = 0; k < 3; ++k) {
            start_error_[k] = scale * error_of(points.start_error, most_at_start[k]);
            end_error_[k] = scale * error_of(points.end_error, most_at_end[k]);
            for (std::size_t i = 0; i < 6; ++i) {
                start_[i][k] *= scale;
                end_[i][k] *= scale;
            }
        }
    }

    // Returns true if all numbers are small enough for the error bound to hold.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return is_bounded_; }

    ECODS_ALWAYS_INLINE Points<6> at(double s) const noexcept {
        Points<6> result;
        const double rest = 1 - s;
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < 3; ++k) result[i][k] = start_[i][k] * rest + end_[i][k] * s;
        }
        return result;
    }

    // Returns factors e_k at time s: |n_0| e_0 + |n_1| e_1 + |n_2| e_2 + `underflow` is an upper bound of the error of
    // the difference of two projections on n.
    ECODS_ALWAYS_INLINE Point error_at(double s) const noexcept {
        const double rest = 1 - s;
        return {start_error_[0] * rest + end_error_[0] * s, start_error_[1] * rest + end_error_[1] * s,
                start_error_[2] * rest + end_error_[2] * s};
    }
    // Returns factors e_k, as in error_at(), that hold at all times.
    ECODS_ALWAYS_INLINE Point error() const noexcept {
        return {std::max(start_error_[0], end_error_[0]), std::max(start_error_[1], end_error_[1]),
                std::max(start_error_[2], end_error_[2])};
    }
    // Returns, for each axis, the largest distance that any corner travels along it, as computed.
    ECODS_ALWAYS_INLINE Point way() const noexcept {
        Point result{};
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < 3; ++k) result[k] = std::max(result[k], std::abs(end_[i][k] - start_[i][k]));
        }
        return result;
    }

    // Returns a power of two p with 1 <= p x < 2. If x is below 2^-1000, p x < 1. x must be in [0, 2^1001).
    ECODS_ALWAYS_INLINE static double inverse_power(double x) noexcept {
        const auto exponent = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) >> 52);  // x >= 0
        const std::int64_t clamped = std::clamp<std::int64_t>(exponent, 23, 2023);
        return std::bit_cast<double>(static_cast<std::uint64_t>(2046 - clamped) << 52);
    }

  private:
    ECODS_ALWAYS_INLINE static double error_of(double error, double most) noexcept {
        return 2.25 * (error + two_u * most) + 20 * two_u * most;
    }

    Points<6> start_, end_;
    Point start_error_, end_error_;
    bool is_bounded_;
};

}  // namespace ecods::exact
