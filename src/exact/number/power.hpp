// Doubles are multiplied by powers of two by means of their bits. The result does not depend on the floating-point
// environment, and no subnormal number is taken for zero.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// Stands for the exponent of zero. The sum of exponent_of_zero and any exponent is below -2148, and the sum of the
// exponents of two numbers that are not zero is at least -2148.
inline constexpr int exponent_of_zero = -8192;

// Returns 2^e. The result must be a normal number.
constexpr double power_of_two(int e) noexcept {
    ECODS_ASSERT(e >= -1022 && e <= 1023);
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

// Returns the least e with |x| < 2^e; exponent_of_zero for 0. x must be finite.
constexpr int exponent_above(double x) noexcept {
    const Dyadic d = decode(x);
    return d.m == 0 ? exponent_of_zero : d.e + static_cast<int>(std::bit_width(magnitude(d.m)));
}

// Returns x * 2^e, or zero if |x * 2^e| < 2^-1022. x must be finite, and |x * 2^e| below 2^1024.
inline double times_power(double x, int e) noexcept {
    const Dyadic d = decode(x);
    const auto width = static_cast<int>(std::bit_width(magnitude(d.m)));
    if (d.m == 0 || d.e + e + width <= -1022) return 0;
    ECODS_ASSERT(d.e + e + width <= 1024);
    const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(d.m));  // exact: d.m is below 2^53
    return std::bit_cast<double>(bits + (static_cast<std::uint64_t>(std::int64_t{d.e} + e) << 52));
}

// Returns x * 2^e rounded up: the least double >= x * 2^e. x must be finite.
inline double times_power_above(double x, int e) noexcept {
    constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;
    const Dyadic d = decode(x);
    if (d.m == 0) return 0;
    const std::uint64_t size = magnitude(d.m);
    const int low = d.e + e, high = low + static_cast<int>(std::bit_width(size));  // the range of digits
    if (high > 1024) return d.m > 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::lowest();
    if (high > -1022) return times_power(x, e);
    // The result is subnormal: a multiple of 2^-1074. Since m is odd, dropping any digit of m changes the number.
    if (low >= -1074) return std::bit_cast<double>(size << (low + 1074) | (d.m < 0 ? sign_bit : 0));
    const std::uint64_t kept = low > -1074 - 64 ? size >> (-1074 - low) : 0;
    return std::bit_cast<double>(d.m < 0 ? kept | sign_bit : kept + 1);
}

}  // namespace ecods::exact
