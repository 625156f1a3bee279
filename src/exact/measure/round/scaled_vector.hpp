// A ScaledVector is a vector of integers in doubles, times a power of two. It approximates a difference of integer
// points.
//
// The coordinates are integers of magnitude at most 2^53, so conversions to double are exact. Products and sums of a
// few factors do not overflow, and numbers that are not zero are far from underflow. Therefore the rounding mode of
// conversions, flush-to-zero, and the scale of the scene have no effect.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/assert.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/integer_frame.hpp"
#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// A ScaledVector is x 2^shift. If shift > 0, each coordinate is rounded down, by less than one unit of x; otherwise x
// is exact. The largest coordinate has 53 digits or is -2^53, or shift is 0.
struct ScaledVector {
    Point x;
    int shift;
};

using IntegerVector = IntegerFrame::Point;

ECODS_ALWAYS_INLINE IntegerVector difference(const IntegerVector& to, const IntegerVector& from) noexcept {
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// Returns a number that has as many binary digits as the coordinate of largest magnitude; one digit less if that
// coordinate is -2^k.
ECODS_ALWAYS_INLINE Uint128 digits_of(const IntegerVector& v) noexcept {
    return static_cast<Uint128>((v[0] ^ (v[0] >> 127)) | (v[1] ^ (v[1] >> 127)) | (v[2] ^ (v[2] >> 127)));
}

// Returns the right shift after which numbers with these digits are in [-2^53, 2^53).
ECODS_ALWAYS_INLINE int shift_of(Uint128 digits) noexcept {
    return std::max(0, bit_width(digits) - 53);
}

ECODS_ALWAYS_INLINE Point shifted(const IntegerVector& v, int shift) noexcept {
    return {static_cast<double>(static_cast<std::int64_t>(v[0] >> shift)),
            static_cast<double>(static_cast<std::int64_t>(v[1] >> shift)),
            static_cast<double>(static_cast<std::int64_t>(v[2] >> shift))};
}

// Returns v, scaled such that its largest coordinate has 53 digits. A vector with fewer digits is scaled up only if it
// is exact; an inexact one would gain no information, and gets shift 0.
ECODS_ALWAYS_INLINE ScaledVector scaled(const IntegerVector& v, bool is_exact) noexcept {
    const int shift = bit_width(digits_of(v)) - 53;
    if (shift >= 0) [[likely]]
        return {shifted(v, shift), shift};
    if (!is_exact) return {shifted(v, 0), 0};
    return {shifted({v[0] << -shift, v[1] << -shift, v[2] << -shift}, 0), shift};
}

// Return lower and upper bounds of x 2^e, which are exact unless they underflow or overflow. x must be normal, and at
// least 2^-200.
inline double scaled_down(double x, int e) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52) + e;
    if (biased <= 0) return 0;
    if (biased >= 0x7ff) return std::numeric_limits<double>::max();
    return std::bit_cast<double>((bits & ((std::uint64_t{1} << 52) - 1)) | static_cast<std::uint64_t>(biased) << 52);
}
inline double scaled_up(double x, int e) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52) + e;
    if (biased <= 0) return std::numeric_limits<double>::min();
    if (biased >= 0x7ff) return std::numeric_limits<double>::infinity();
    return std::bit_cast<double>((bits & ((std::uint64_t{1} << 52) - 1)) | static_cast<std::uint64_t>(biased) << 52);
}

}  // namespace ecods::exact
