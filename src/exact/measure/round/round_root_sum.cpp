// A RootSum a + b, a rational and b a root, is rounded in two steps.
//
// 1. Digits without cancellation. If a and b have one sign, |a + b| = |a| + |b|. Otherwise |a + b| = |a^2 - b^2| / (|a|
// + |b|), where a^2 - b^2 = (x^2 w 4^e - y z^2 4^f) / (z^2 w) is computed exactly. So all operations are quotients,
// roots and sums of positive numbers, and relative errors do not grow.
//
// Errors. A quotient of integers is cut to 127 digits, at most 2^-126 of it. If the divisor is longer than four limbs,
// both integers are first cut to their four leading limbs, at most 2^-192 of each. A root has 2^-94 from
// inverse_root(), and less than 2^-123 from all digits that are cut off. A sum of two numbers of at least 127 digits is
// off by their greater error, and 2^-124 for digits that are cut off. A quotient of two numbers has the sum of their
// errors and 2^-126. Altogether less than 2^-94 + 2^-122 < 2^-93. A result of 128 digits is below 2^128 units, so its
// error is below 2^35 units.
// Claim: verify/proofs/root_sums.py
//
// 2. If these digits do not decide, the sum lies near the middle m of two adjacent doubles. Since |a + b| - m is again
// a RootSum, with x - m z for x, its sign decides exactly, and says if the sum is the middle itself.
#include "exact/measure/round/round_root_sum.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "base/double_key.hpp"
#include "exact/measure/round/fixed_digits.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

constexpr Uint128 error_of_digits = Uint128{1} << 35;

// An Approximate is a positive number or zero as digits 2^exponent, with a small relative error. `digits` is 0 for
// zero, otherwise at least 2^125.
struct Approximate {
    Uint128 digits = 0;
    int exponent = 0;
};

// A Cut refers to an integer without some of its low limbs.
struct Cut {
    NaturalSpan limbs;
    int exponent;  // of the unit of `limbs`
};
Cut cut_to(NaturalSpan all, std::size_t limb_count) noexcept {
    const std::size_t dropped = all.size() - std::min(all.size(), limb_count);
    return {all.subspan(dropped), static_cast<int>(64 * dropped)};
}

Approximate quotient(NaturalSpan num, NaturalSpan den, int exponent) noexcept {
    constexpr std::size_t most = 4;
    const bool is_long = den.size() > most;
    const Cut n = is_long ? cut_to(num, most) : Cut{num, 0}, d = is_long ? cut_to(den, most) : Cut{den, 0};
    const LeadingDigits digits = leading_digits(n.limbs, d.limbs);
    return {digits.digits, exponent + digits.exponent + n.exponent - d.exponent};
}

Approximate quotient(const Approximate& num, const Approximate& den) noexcept {
    const auto limbs = [](const Approximate& x) {
        return std::array{static_cast<std::uint64_t>(x.digits), static_cast<std::uint64_t>(x.digits >> 64)};
    };
    const auto n = limbs(num), d = limbs(den);
    return quotient(without_leading_zeros(n), without_leading_zeros(d), num.exponent - den.exponent);
}

// Returns the square root of `square`. Let s = digits 2^shift have 252 or 253 bits, with an even exponent left. Then
// sqrt(s) 2^125 = (s / 2^127) (2^252 / sqrt(s)).
Approximate root(const Approximate& square) noexcept {
    if (square.digits == 0) return {};
    int shift = 252 - bit_width(square.digits);
    if (((square.exponent - shift) & 1) != 0) ++shift;
    const Int256 s{square.digits << shift, static_cast<Int128>(square.digits >> (128 - shift))};
    const Int256 product = multiply_halves(static_cast<Uint128>(shifted(s, 127)), inverse_root(s));
    const int drop = bit_width(product) - 128;
    return {static_cast<Uint128>(shifted(product, drop)), (square.exponent - shift) / 2 + drop - 125};
}

Approximate operator+(const Approximate& x, const Approximate& y) noexcept {
    if (x.digits == 0 || y.digits == 0) return x.digits == 0 ? y : x;
    if (x.exponent < y.exponent) return y + x;
    const int shift = std::min(x.exponent - y.exponent + 1, 127);
    return {(x.digits >> 1) + (y.digits >> shift), x.exponent + 1};
}

// A Sized holds the sign of a sum, and the sum's absolute value as an approximation.
struct Sized {
    int sign = 0;
    Approximate size;
};

Sized size_of(const RootSum& sum) {
    const Approximate a = quotient(sum.x.limbs(), sum.z.limbs(), sum.e);
    const Approximate b = root(quotient(sum.y.limbs(), sum.w.limbs(), 2 * sum.f));
    const int of_x = sum.x.sign(), of_root = sum.root_sign();
    if (of_x * of_root >= 0) return {of_x != 0 ? of_x : of_root, a + b};
    const int unit = std::min(sum.e, sum.f);
    const Integer zz = sum.z * sum.z;
    const Integer aa = (sum.x * sum.x * sum.w) << (2 * (sum.e - unit)), bb = (sum.y * zz) << (2 * (sum.f - unit));
    const Integer difference = aa - bb;
    if (difference.is_zero()) return {};
    return {of_x * difference.sign(), quotient(quotient(difference.limbs(), (zz * sum.w).limbs(), 2 * unit), a + b)};
}

// Returns the middle of the double with these bits, which is not negative, and the next double, infinity taken for
// 2^1024.
Dyadic middle_above(std::uint64_t bits) noexcept {
    const int biased = static_cast<int>(bits >> 52);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t size = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    return {static_cast<std::int64_t>(2 * size + 1), std::max(biased, 1) - 1076};
}

// Returns the sign of |sum| - m, where `sign` is the sum's sign.
int compare_size(const RootSum& sum, int sign, const Dyadic& m) {
    RootSum rest = sum;
    rest.e = std::min(sum.e, m.e);
    rest.x = (sum.x << (sum.e - rest.e)) - ((sum.z * Integer(sign * m.m)) << (m.e - rest.e));
    return sign * exact::sign(rest);
}

double round_sized(const RootSum& sum, const Sized& sized) {
    const auto& [sign, size] = sized;
    if (sign == 0) return 0;
    const int up = 128 - bit_width(size.digits);
    const FixedDigits digits{size.digits << up, size.exponent - up, error_of_digits};
    if (const auto rounded = digits.rounded()) return with_sign(std::bit_cast<std::uint64_t>(*rounded), sign < 0);
    const auto low =
        std::bit_cast<std::uint64_t>(round_digits({digits.digits - digits.error - 1, digits.exponent, false}));
    const int above = compare_size(sum, sign, middle_above(low));
    return with_sign(low + (above > 0 || (above == 0 && (low & 1) != 0) ? 1 : 0), sign < 0);
}

}  // namespace

double round_root_sum(const RootSum& sum) {
    return round_sized(sum, size_of(sum));
}

double round_signed(const RootSum& sum) {
    const Sized sized = size_of(sum);
    const auto bits = std::bit_cast<std::uint64_t>(round_sized(sum, sized));
    return bits == 0 && sized.sign != 0 ? with_sign(1, sized.sign < 0) : std::bit_cast<double>(bits);
}

double round_positive_part(const RootSum& sum) {
    return positive_part(round_signed(sum));
}

}  // namespace ecods::exact
