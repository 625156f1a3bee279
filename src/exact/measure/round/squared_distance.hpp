// The square of a distance as a fraction of integers, and what is asked of it.
#pragma once

#include "exact/number/natural.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

// Points of limb_count_max limbs have numerators of up to six times that, see exact_features.hpp.
inline constexpr std::size_t numerator_limbs = 6 * limb_count_max;
inline constexpr std::size_t denominator_limbs = 4 * limb_count_max;
// The longest number that is divided by.
inline constexpr std::size_t divisor_limbs = numerator_limbs;

// num / den * 4^exponent.
struct SquaredDistance {
    Natural<numerator_limbs> num;
    Natural<denominator_limbs> den{1};
    int exponent = 0;
};

// The double nearest to the distance, ties to even; at least 2^-1074 if it is positive, infinity above the largest
// double. No floating-point environment shows in it.
double round_root(const SquaredDistance& square) noexcept;

// The double nearest to num / den * 2^exponent, or its negative; a zero is +0. den > 0.
double round_quotient(NaturalSpan num, NaturalSpan den, int exponent, bool negative) noexcept;

// The leading digits of num / den = (digits + rest) 2^exponent, 0 <= rest < 1: 127 or 128 of them, none of zero.
struct LeadingDigits {
    Uint128 digits = 0;
    int exponent = 0;
    bool is_exact = true;  // whether rest is 0
};
LeadingDigits leading_digits(NaturalSpan num, NaturalSpan den) noexcept;

// The double nearest to that quotient; to x * 2^exponent. A zero is +0.
double round_digits(const LeadingDigits& x) noexcept;
double round_integer(const Int256& x, int exponent) noexcept;

// The double nearest to the square root of num / den <= 1, or its negative: a coordinate of a unit vector. A zero is
// +0.
double round_cosine(NaturalSpan num, NaturalSpan den, bool negative) noexcept;

// The sign of the distance less d. d >= 0, or infinity.
int compare(const SquaredDistance& square, double d) noexcept;

// The sign of the first less the second.
int compare(const SquaredDistance& first, const SquaredDistance& second) noexcept;

}  // namespace ecods::exact
