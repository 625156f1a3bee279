// Single precision, rounded outwards: what a tree's boxes are made of. By bits: no rounding mode takes part.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "base/arithmetic.hpp"

namespace ecods {

// The least float above x; infinity stays. Not for NaN.
constexpr float next_up(float x) noexcept {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x);
    if (bits == 0x7f800000u) return x;
    if (bits << 1 == 0) return std::bit_cast<float>(std::uint32_t{1});
    return std::bit_cast<float>(bits >> 31 ? bits - 1 : bits + 1);
}

// The greatest float below x; -infinity stays. Not for NaN.
constexpr float next_down(float x) noexcept {
    return -next_up(-x);
}

// The least normal float, which no processor takes for zero.
inline constexpr float float_min = std::numeric_limits<float>::min();

// A float that is not below x, whichever way the conversion rounds. Results below the normal ones become the least
// normal one, or zero.
inline float round_up(double x) noexcept {
    if (x > -static_cast<double>(float_min) && x <= 0) return 0;
    if (x > 0 && x < static_cast<double>(float_min)) return float_min;
    const float f = static_cast<float>(x);
    return static_cast<double>(f) < x ? next_up(f) : f;
}

// A float that is not above x. Not by two negations: a compiler may drop them around a conversion, as if it rounded to
// nearest.
inline float round_down(double x) noexcept {
    if (x >= 0 && x < static_cast<double>(float_min)) return 0;
    if (x < 0 && x > -static_cast<double>(float_min)) return -float_min;
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? next_down(f) : f;
}

}  // namespace ecods
