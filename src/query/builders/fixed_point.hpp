// Fixed-point numbers are integers in units of 2^-60. The curved builders guess vertices in fixed point, so that the
// guesses do not depend on the floating-point environment or on a library's cosine. No decision depends on the digits
// of the guesses: exact signs decide whether the vertices suffice.
#pragma once

#include <cstdint>

#include "exact/number/limbs.hpp"

namespace ecods::builders {

inline constexpr int fixed_bits = 60;
inline constexpr std::int64_t fixed_one = std::int64_t{1} << fixed_bits;

// Returns the product a b, rounded towards zero, so that the signs of factors change only the sign of the product.
inline exact::Int128 multiply_fixed(exact::Int128 a, std::int64_t b) noexcept {
    return a * b / fixed_one;
}

}  // namespace ecods::builders
