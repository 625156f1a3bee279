// Doubles are compared as integers, so that their order cannot depend on the floating-point environment.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace ecods {

// Returns an integer that orders as the double does, infinities included; -0.0 and 0.0 have one key. Only bits are
// read: with denormals-are-zero set, a comparison of doubles would take subnormals for equal.
constexpr std::int64_t key_of(double x) noexcept {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t sign = bits >> 63;  // all ones below zero
    return ((bits & std::numeric_limits<std::int64_t>::max()) ^ sign) - sign;
}

// Returns the double that has this key.
constexpr double double_of(std::int64_t key) noexcept {
    const std::int64_t sign = key >> 63;
    return std::bit_cast<double>(((key ^ sign) - sign) | (sign & std::numeric_limits<std::int64_t>::min()));
}

// True for the numbers from 0 on, infinity included; -0.0 is 0. The key of a NaN lies beyond the keys of the
// infinities.
constexpr bool is_from_zero(double x) noexcept {
    return key_of(x) >= 0 && key_of(x) <= key_of(std::numeric_limits<double>::infinity());
}

}  // namespace ecods
