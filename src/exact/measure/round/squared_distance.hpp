// A SquaredDistance is the exact square of a distance, as a fraction of integers. The functions of this file round and
// compare such distances.
#pragma once

#include <bit>
#include <cstdint>

#include "exact/number/natural.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

// Points of limb_count_max limbs give numerators of up to six times as many limbs (exact_features.hpp).
inline constexpr std::size_t numerator_limbs = 6 * limb_count_max;
inline constexpr std::size_t denominator_limbs = 4 * limb_count_max;
// round_root() takes denominators of at most divisor_limbs limbs.
inline constexpr std::size_t divisor_limbs = numerator_limbs;

// A SquaredDistance is the number num / den * 4^exponent.
struct SquaredDistance {
    Natural<numerator_limbs> num;
    Natural<denominator_limbs> den{1};
    int exponent = 0;
};

// Returns the double with the bits `bits`, or its negative if `negative`; a zero is +0. The sign bit of `bits` must not
// be set.
inline double with_sign(std::uint64_t bits, bool negative) noexcept {
    return std::bit_cast<double>(negative && bits != 0 ? bits | std::uint64_t{1} << 63 : bits);
}

// Returns the double nearest to the distance (the root), ties to even: at least 2^-1074 if the distance is positive,
// and infinity if it is above the largest double. The floating-point environment has no effect.
double round_root(const SquaredDistance& square) noexcept;

// Returns the root of num / den * 4^exponent, rounded as by the function above. den must be positive, and have at most
// divisor_limbs limbs.
double round_root(NaturalSpan num, NaturalSpan den, int exponent) noexcept;

// Returns the double nearest to num / den * 2^exponent, or to its negative if `negative`; a zero is +0. den must be >
// 0.
double round_quotient(NaturalSpan num, NaturalSpan den, int exponent, bool negative) noexcept;

// LeadingDigits holds the 127 or 128 leading digits of num / den = (digits + rest) 2^exponent, 0 <= rest < 1. digits is
// 0 if num is 0.
struct LeadingDigits {
    Uint128 digits = 0;
    int exponent = 0;
    bool is_exact = true;  // true if rest is 0
};
LeadingDigits leading_digits(NaturalSpan num, NaturalSpan den) noexcept;

// round_digits() returns the double nearest to the number whose leading digits are x; round_integer() returns the
// double nearest to x * 2^exponent. A zero is +0.
double round_digits(const LeadingDigits& x) noexcept;
double round_integer(const Int256& x, int exponent) noexcept;

// Returns the double nearest to sqrt(num / den) <= 1, or to its negative if `negative`: a coordinate of a unit vector.
// A zero is +0.
double round_cosine(NaturalSpan num, NaturalSpan den, bool negative) noexcept;

// Returns the sign of distance - d. d must be >= 0, and may be infinity.
int compare(const SquaredDistance& square, double d) noexcept;

// Returns the sign of first - second.
int compare(const SquaredDistance& first, const SquaredDistance& second) noexcept;

}  // namespace ecods::exact
