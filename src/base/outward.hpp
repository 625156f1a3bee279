// Doubles are narrowed to single precision: outwards, for the boxes of trees, and to nearest.
//
// Narrowing works on the bits of the double, so no rounding mode and no optimiser takes part. That is needed: compilers
// drop a conversion to float and back. g++ 12, vectorising straight-line code, computes with the double that was not
// rounded (with -O3, in places with -O2). A float compared with the double that it came from would then always equal
// it, and a box could end inside what it is to contain.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/arithmetic.hpp"

namespace ecods {

// The least normal float, which no processor takes for zero.
inline constexpr float float_min = std::numeric_limits<float>::min();

// The magnitude of a number is its bits without the sign. Magnitudes order as the numbers do.
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

// Rounds a magnitude down to a float: the greatest that is at most as large, zero or normal or infinite.
constexpr std::uint32_t narrowed_inwards(std::uint64_t magnitude) noexcept {
    if (magnitude < widened(float_min_magnitude)) return 0;
    if (magnitude > widened(float_max_magnitude)) {
        return magnitude == double_infinity_magnitude ? float_infinity_magnitude : float_max_magnitude;
    }
    return static_cast<std::uint32_t>((magnitude - narrowed_bias) >> narrowed_bits);
}

// Rounds a magnitude up to a float: the least that is at least as large. A carry out of the fraction rightly goes on
// into the exponent.
constexpr std::uint32_t narrowed_outwards(std::uint64_t magnitude) noexcept {
    if (magnitude == 0) return 0;
    if (magnitude < widened(float_min_magnitude)) return float_min_magnitude;
    if (magnitude > widened(float_max_magnitude)) return float_infinity_magnitude;
    return static_cast<std::uint32_t>((magnitude - narrowed_bias + narrowed_mask) >> narrowed_bits);
}

// Returns the negative of a float that is given by its magnitude; zero for zero.
constexpr float negated(std::uint32_t magnitude) noexcept {
    return std::bit_cast<float>(magnitude == 0 ? 0 : magnitude | 0x80000000u);
}

// Returns the least float, zero or normal or infinite, that is at least x. Not for NaN.
constexpr float round_up(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    return has_sign(x) ? negated(narrowed_inwards(magnitude)) : std::bit_cast<float>(narrowed_outwards(magnitude));
}

// Returns the greatest float, zero or normal or infinite, that is at most x. Not for NaN.
constexpr float round_down(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    return has_sign(x) ? negated(narrowed_outwards(magnitude)) : std::bit_cast<float>(narrowed_inwards(magnitude));
}

// Returns the float nearest to x, ties to even, or zero if |x| is below the least normal float. Not for NaN. For floats
// that are read as doubles afterwards.
constexpr float round_to_nearest(double x) noexcept {
    const std::uint64_t magnitude = magnitude_of(x);
    if (magnitude < widened(float_min_magnitude)) return 0;
    const std::uint64_t is_odd = magnitude >> narrowed_bits & 1;
    const std::uint64_t rounded = (magnitude - narrowed_bias + (narrowed_mask >> 1) + is_odd) >> narrowed_bits;
    const auto narrowed = static_cast<std::uint32_t>(std::min<std::uint64_t>(rounded, float_infinity_magnitude));
    return has_sign(x) ? negated(narrowed) : std::bit_cast<float>(narrowed);
}

}  // namespace ecods
