#include "exact/measure/round/fraction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "base/outward.hpp"
#include "exact/measure/round/natural_sum.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

static_assert(fraction_limbs <= divisor_limbs);

constexpr std::size_t double_limbs = 1074 / 64 + 1;

Uint128 two_limbs(NaturalSpan a) noexcept {
    return (a.size() > 1 ? Uint128{a[1]} << 64 : 0) | (a.empty() ? 0 : a[0]);
}

// Returns m * 2^shift. shift must be >= 0, and the result must fit into 256 bits.
Int256 shifted(Int128 m, int shift) noexcept {
    if (shift >= 128) return {0, m << (shift - 128)};
    return {static_cast<Uint128>(m) << shift, shift == 0 ? m >> 127 : m >> (128 - shift)};
}

// Sets `rounded` to the double nearest to from + along * s and returns true. s = (digits + rest) 2^exponent, 0 <= rest
// < 1. Returns false if the digits do not determine the nearest double.
//
// Let along = m 2^e, |m| < 2^64. The sum lies between from + digits m 2^(e + exponent) and that number plus m 2^(e +
// exponent). Rounding is monotone: if both ends round to the same double, so does the sum. Products are below 2^192,
// and numbers added to them below 2^250.
bool round_from_digits(const Dyadic& from, const DyadicDifference& along, const LeadingDigits& s,
                       double& rounded) noexcept {
    const Uint128 size = size_of(along.m);
    if ((size >> 64) != 0) return false;
    const int unit = s.exponent + along.e, shift = from.m == 0 ? 0 : from.e - unit;
    if (size == 0 || s.digits == 0) {
        rounded = round_integer(shifted(from.m, 0), from.e);
        return true;
    }
    if (shift < 0 || shift > 250 - mantissa_bits) return false;
    const Int256 start = shifted(from.m, shift), product = multiply_halves(s.digits, size);
    const Int256 low = along.m < 0 ? start - product : start + product;
    rounded = round_integer(low, unit);
    if (s.is_exact) return true;
    const Int256 rest{size, 0}, high = along.m < 0 ? low - rest : low + rest;
    return std::bit_cast<std::uint64_t>(rounded) == std::bit_cast<std::uint64_t>(round_integer(high, unit));
}

double at_least_positive(double rounded, const FractionRef& x) noexcept {
    return x.num.empty() ? 0 : std::bit_cast<double>(std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(rounded), 1));
}

}  // namespace

Fraction fraction_of(double x) noexcept {
    const Dyadic d = decode(x);
    Fraction result;
    if (d.m == 0) return result;
    const std::uint64_t m = magnitude(d.m);
    std::array<std::uint64_t, double_limbs + 1> shifted;
    const auto assign = [&](auto& to, NaturalSpan from, int shift) {
        for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] = limb_of_shifted(from, shift, i);
        to.assign(shifted);
    };
    const std::uint64_t one = 1;
    assign(result.num, {&m, 1}, std::max(d.e, 0));
    assign(result.den, {&one, 1}, std::max(-d.e, 0));
    return result;
}

// Returns the sign of first - second, from the cross products of numerators and denominators: numbers of 3k + 6 bits
// give products of 6k + 12 bits. Usually the numbers' bit widths suffice.
int compare(const FractionRef& first, const FractionRef& second) noexcept {
    if (first.num.empty() || second.num.empty()) {
        return static_cast<int>(!first.num.empty()) - static_cast<int>(!second.num.empty());
    }
    if (std::ranges::equal(first.den, second.den)) return compare_shifted(first.num, 0, second.num);
    const int difference =
        (bit_width(first.num) + bit_width(second.den)) - (bit_width(second.num) + bit_width(first.den));
    if (std::abs(difference) > 1) return difference < 0 ? -1 : 1;
    if (std::max({first.num.size(), first.den.size(), second.num.size(), second.den.size()}) <= 2) {
        const Int256 a = multiply_halves(two_limbs(first.num), two_limbs(second.den)),
                     b = multiply_halves(two_limbs(second.num), two_limbs(first.den));
        const auto high_a = static_cast<Uint128>(a.high), high_b = static_cast<Uint128>(b.high);
        if (high_a != high_b) return high_a < high_b ? -1 : 1;
        return static_cast<int>(a.low > b.low) - static_cast<int>(a.low < b.low);
    }
    Natural<2 * fraction_limbs> a, b;
    a.assign_product(first.num, second.den);
    b.assign_product(second.num, first.den);
    return compare_shifted(a.limbs(), 0, b.limbs());
}

int compare(const FractionRef& first, double x) noexcept {
    if (magnitude_of(x) == double_infinity_magnitude) return -1;
    const Dyadic d = decode(x);
    ECODS_ASSERT(d.m >= 0);
    if (d.m == 0) return first.num.empty() ? 0 : 1;
    const std::uint64_t m = magnitude(d.m);
    Natural<fraction_limbs + 1> product;
    product.assign_product(first.den, {&m, 1});
    return compare_shifted(first.num, -d.e, product.limbs());
}

double round_fraction(const FractionRef& x) noexcept {
    return at_least_positive(round_quotient(x.num, x.den, 0, false), x);
}

RoundedOnLine round_on_line(const Vec3& a, const Vec3& b, bool is_direction, const FractionRef& at) noexcept {
    RoundedOnLine result;
    const LeadingDigits digits = leading_digits(at.num, at.den);
    result.parameter = at_least_positive(round_digits(digits), at);
    for (int k = 0; k < 3; ++k) {
        const Dyadic from = decode(a[k]), to = decode(b[k]);
        const auto along = subtract(to, is_direction ? Dyadic{} : from);
        if (along && round_from_digits(from, *along, digits, result.point[k])) continue;
        const std::uint64_t from_size = magnitude(from.m), to_size = magnitude(to.m);
        const auto term = [](const std::uint64_t& size, const Dyadic& x, NaturalSpan times, bool is_turned) {
            return Summand{without_leading_zeros({&size, 1}), times, x.e, (x.m < 0) != is_turned};
        };
        const std::array<Summand, 3> terms{term(from_size, from, at.den, false), term(to_size, to, at.num, false),
                                           term(from_size, from, at.num, true)};
        result.point[k] = round_sum(std::span(terms).first(is_direction ? 2 : 3), at.den);
    }
    return result;
}

}  // namespace ecods::exact
