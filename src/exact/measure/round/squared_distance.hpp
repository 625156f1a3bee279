// A SquaredDistance is the exact square of a distance as a fraction of integers, to be rounded and compared.
#pragma once

#include "exact/number/natural.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

// Points of limb_count_max limbs have numerators of up to six times as many, see exact_features.hpp.
inline constexpr std::size_t numerator_limbs = 6 * limb_count_max;
inline constexpr std::size_t denominator_limbs = 4 * limb_count_max;
// The number of limbs of the longest divisor.
inline constexpr std::size_t divisor_limbs = numerator_limbs;

// Holds num / den * 4^exponent.
struct SquaredDistance {
    Natural<numerator_limbs> num;
    Natural<denominator_limbs> den{1};
    int exponent = 0;
};

// Returns the double nearest to the distance, ties to even; at least 2^-1074 if it is positive, infinity above the
// largest double. The floating-point environment has no effect.
double round_root(const SquaredDistance& square) noexcept;

// Returns the double nearest to num / den * 2^exponent, or its negative; a zero is +0. den > 0.
double round_quotient(NaturalSpan num, NaturalSpan den, int exponent, bool negative) noexcept;

// Holds the leading digits of num / den = (digits + rest) 2^exponent, 0 <= rest < 1: 127 or 128 bits, and 0 for zero.
struct LeadingDigits {
    Uint128 digits = 0;
    int exponent = 0;
    bool is_exact = true;  // true if rest is 0
};
LeadingDigits leading_digits(NaturalSpan num, NaturalSpan den) noexcept;

// Return the double nearest to a quotient from its leading digits, and to x * 2^exponent. A zero is +0.
double round_digits(const LeadingDigits& x) noexcept;
double round_integer(const Int256& x, int exponent) noexcept;

// Returns the double nearest to sqrt(num / den) <= 1, or its negative: a coordinate of a unit vector. A zero is +0.
double round_cosine(NaturalSpan num, NaturalSpan den, bool negative) noexcept;

// Returns the sign of the distance less d. d >= 0, or infinity.
int compare(const SquaredDistance& square, double d) noexcept;

// Returns the sign of the first less the second.
int compare(const SquaredDistance& first, const SquaredDistance& second) noexcept;

}  // namespace ecods::exact
