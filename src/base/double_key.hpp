// Doubles are mapped to integers ("keys") of the same order. Comparing keys gives the same result in every
// floating-point environment.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace ecods {

// Returns an integer with the same order as the double: x < y if and only if key_of(x) < key_of(y). Infinities have
// keys; -0.0 and 0.0 have the same key. Works on the bits, because with denormals-are-zero set a comparison of doubles
// would take subnormal numbers for equal.
constexpr std::int64_t key_of(double x) noexcept {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t sign = bits >> 63;  // all ones if x is negative, otherwise 0
    return ((bits & std::numeric_limits<std::int64_t>::max()) ^ sign) - sign;
}

// Returns the double x with key_of(x) == key.
constexpr double double_of(std::int64_t key) noexcept {
    const std::int64_t sign = key >> 63;
    return std::bit_cast<double>(((key ^ sign) - sign) | (sign & std::numeric_limits<std::int64_t>::min()));
}

// Returns -x; +0 if x is a zero.
constexpr double opposite(double x) noexcept {
    return double_of(-key_of(x));
}

// Returns x if it is positive, otherwise +0.
constexpr double positive_part(double x) noexcept {
    return key_of(x) > 0 ? x : 0;
}

// Returns true if x >= 0, also for infinity and -0.0. Returns false for NaN, whose key is beyond the keys of both
// infinities.
constexpr bool is_from_zero(double x) noexcept {
    return key_of(x) >= 0 && key_of(x) <= key_of(std::numeric_limits<double>::infinity());
}

}  // namespace ecods
