// Doubles are rounded to floats: outwards, for the boxes of trees, or to nearest.
//
// All rounding here works on the bits of the double, so it depends neither on the rounding mode nor on the optimiser. A
// conversion to float and back would not do, because compilers drop it: g++ 12 vectorises straight-line code (with -O3,
// in places with -O2) and then computes with the unrounded double. A float compared with its own double would then
// always be equal to it, and a box could end inside the set that it must contain.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/arithmetic.hpp"

namespace ecods {

// float_min is the least normal float. Smaller positive floats are subnormal, and a processor may take them for zero.
inline constexpr float float_min = std::numeric_limits<float>::min();

// The magnitude of a number x is the bit pattern of |x|. Magnitudes have the same order as the absolute values.
inline constexpr std::uint32_t float_infinity_magnitude = 0x7f800000u;
inline constexpr std::uint32_t float_min_magnitude = std::bit_cast<std::uint32_t>(float_min);
inline constexpr std::uint32_t float_max_magnitude = float_infinity_magnitude - 1;
inline constexpr std::uint64_t double_infinity_magnitude = 0x7ff0000000000000u;

// A double's fraction has 29 more bits than a float's, and the bias of its exponent is greater by 1023 - 127.
inline constexpr int narrowed_bits = 29;
inline constexpr std::uint64_t narrowed_mask = (std::uint64_t{1} << narrowed_bits) - 1;
inline constexpr std::uint64_t narrowed_bias = std::uint64_t{1023 - 127} << 52;

// Returns the magnitude of the double that equals a normal float.
constexpr std::uint64_t widened(std::uint32_t magnitude) noexcept {
    return (std::uint64_t{magnitude} << narrowed_bits) + narrowed_bias;
}

constexpr std::uint64_t magnitude_of(double x) noexcept {
    return std::bit_cast<std::uint64_t>(x) << 1 >> 1;
}

constexpr bool has_sign(double x) noexcept {
    return std::bit_cast<std::uint64_t>(x) >> 63 != 0;
}

// Rounds a double's magnitude towards zero to the magnitude of a float that is zero, normal or infinite.
constexpr std::uint32_t narrowed_inwards(std::uint64_t magnitude) noexcept {
    if (magnitude < widened(float_min_magnitude)) return 0;
    if (magnitude > widened(float_max_magnitude)) {
        return magnitude == double_infinity_magnitude ? float_infinity_magnitude : float_max_magnitude;
    }
    return static_cast<std::uint32_t>((magnitude - narrowed_bias) >> narrowed_bits);
}

// Rounds a double's magnitude away from zero to the magnitude of a float that is zero, normal or infinite. A carry out
// of the fraction increases the exponent, which gives the right float.
constexpr std::uint32_t narrowed_outwards(std::uint64_t magnitude) noexcept {
    if (magnitude == 0) return 0;
    if (magnitude < widened(float_min_magnitude)) return float_min_magnitude;
    if (magnitude > widened(float_max_magnitude)) return float_infinity_magnitude;
    return static_cast<std::uint32_t>((magnitude - narrowed_bias + narrowed_mask) >> narrowed_bits);
}

// Returns minus the float with this magnitude; +0 if the magnitude is 0.
constexpr float negated(std::uint32_t magnitude) noexcept {
    return std::bit_cast<float>(magnitude == 0 ? 0 : magnitude | 0x80000000u);
}

// Returns the least float >= x among zero, normal floats and infinities. x must not be NaN.
constexpr float round_up(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    return has_sign(x) ? negated(narrowed_inwards(magnitude)) : std::bit_cast<float>(narrowed_outwards(magnitude));
}

// Returns the greatest float <= x among zero, normal floats and infinities. x must not be NaN.
constexpr float round_down(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    return has_sign(x) ? negated(narrowed_outwards(magnitude)) : std::bit_cast<float>(narrowed_inwards(magnitude));
}

// Returns the float nearest to x, ties to even, or zero if |x| is below the least normal float. x must not be NaN.
constexpr float round_to_nearest(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    if (magnitude < widened(float_min_magnitude)) return 0;
    const std::uint64_t is_odd = magnitude >> narrowed_bits & 1;
    const std::uint64_t rounded = (magnitude - narrowed_bias + (narrowed_mask >> 1) + is_odd) >> narrowed_bits;
    const auto narrowed = static_cast<std::uint32_t>(std::min<std::uint64_t>(rounded, float_infinity_magnitude));
    return has_sign(x) ? negated(narrowed) : std::bit_cast<float>(narrowed);
}

}  // namespace ecods
