// The corners of two triangles on their way, in doubles.
//
// Bound. A corner at time s is computed as P (1 - s) + Q s from its rounded places P and Q, which are off by `error`;
// so is the corner but for three factors (1 + e), |e| <= u' = 2^-52, on either product: 3.01 u' M, where M is the
// largest magnitude on the axis. Taking the reference point off before adds u' M to each of them, which is taken into
// `error`. A product with a vector n meets three more factors on either term: 3.01 u' |n| M. The difference of two such
// projections adds the bound twice, and u' times 2 |n| M. Together 2 error + 14.1 u' M on each axis, times |n|; 2.25
// error + 20 u' M cover the bound's own rounding. Subtracting it adds u' of a number that is at most twice |n| M:
// covered, too.
//
// Underflow. All of it is scaled by a power of two, to magnitudes below 2. That is exact but for what is below 2^-1022
// then; what was below it before is less than 2^-22 of `error`, which is 2^-1000 or more. Vectors n are products of
// three differences at most: below 2^8. An operation that underflows, or a time that is taken for zero, loses 2^-1022
// times such factors: a hundred of them are below 2^-1000, and 2^-990 is added to the bound.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// The corners of both triangles at the times 0 and 1, rounded, and how far they are off on any axis.
struct MovingPoints {
    Points<6> start, end;
    double error;
};

// Times from one to another, from 0 to 1.
struct TimeSpan {
    double from, to;
};

// The same relative to a corner, which they are near to.
class MovingCorners {
  public:
    static constexpr double underflow = 0x1p-990;

    ECODS_ALWAYS_INLINE explicit MovingCorners(const MovingPoints& points) noexcept {
        const Point origin = points.start[0];
        double most_before = points.error, size = 0;
        Point most{};
        for (std::size_t k = 0; k < 3; ++k) {
            most_before = std::max(most_before, std::abs(origin[k]));
            for (std::size_t i = 0; i < 6; ++i) {
                most_before = std::max({most_before, std::abs(points.start[i][k]), std::abs(points.end[i][k])});
                start_[i][k] = points.start[i][k] - origin[k];
                end_[i][k] = points.end[i][k] - origin[k];
                most[k] = std::max({most[k], std::abs(start_[i][k]), std::abs(end_[i][k])});
            }
            size = std::max(size, most[k]);
        }
        is_bounded_ = most_before < 0x1p1000;
        const double scale = inverse_power(size);
        for (std::size_t k = 0; k < 3; ++k) {
            error_[k] = scale * (2.25 * (points.error + two_u * most[k]) + 20 * two_u * most[k]);
            for (std::size_t i = 0; i < 6; ++i) {
                start_[i][k] *= scale;
                end_[i][k] *= scale;
            }
        }
    }

    // Otherwise the bound does not hold.
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return is_bounded_; }

    ECODS_ALWAYS_INLINE Points<6> at(double s) const noexcept {
        Points<6> result;
        const double rest = 1 - s;
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < 3; ++k) result[i][k] = start_[i][k] * rest + end_[i][k] * s;
        }
        return result;
    }

    // Times |n_k|, summed, and with `underflow` added: the bound of a difference of two projections to n, at any time.
    ECODS_ALWAYS_INLINE const Point& error() const noexcept { return error_; }
    // The largest distance on each axis that a corner goes in all, as computed.
    ECODS_ALWAYS_INLINE Point way() const noexcept {
        Point result{};
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < 3; ++k) result[k] = std::max(result[k], std::abs(end_[i][k] - start_[i][k]));
        }
        return result;
    }

  private:
    // A power of two by which x becomes less than 2, and no less than 1 unless it is below 2^-1000.
    ECODS_ALWAYS_INLINE static double inverse_power(double x) noexcept {
        const auto exponent = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) >> 52);  // x >= 0
        const std::int64_t clamped = std::clamp<std::int64_t>(exponent, 23, 2023);
        return std::bit_cast<double>(static_cast<std::uint64_t>(2046 - clamped) << 52);
    }

    Points<6> start_, end_;
    Point error_;
    bool is_bounded_;
};

ECODS_ALWAYS_INLINE Point difference(const Point& a, const Point& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ECODS_ALWAYS_INLINE Point cross(const Point& a, const Point& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace ecods::exact
