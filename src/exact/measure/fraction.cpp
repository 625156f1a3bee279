#include "exact/measure/fraction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

#include "base/outward.hpp"
#include "exact/measure/natural_sum.hpp"
#include "exact/measure/squared_distance.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

static_assert(fraction_limbs <= divisor_limbs);

constexpr std::size_t double_limbs = 1074 / 64 + 1;

// Terms are products of a double, a multiple of 2^-1074 below 2^1024, and a number of fraction_limbs; three of them.
using Sum = NaturalSum<fraction_limbs + (1074 + 1024 + 8) / 64 + 2>;

// A term of a coordinate: x times a natural number.
struct Term {
    Dyadic x;
    NaturalSpan times;
    bool is_negative;
};

double round_coordinate(std::span<const Term> terms, NaturalSpan den) noexcept {
    BitRange range;
    for (const Term& term : terms) {
        if (term.x.m == 0 || term.times.empty()) continue;
        const int width = static_cast<int>(std::bit_width(magnitude(term.x.m)));
        range.include(term.x.e, term.x.e + width + bit_width(term.times));
    }
    if (range.empty()) return 0;
    Sum sum(range.low, range.high);
    for (const Term& term : terms) {
        if (term.x.m == 0 || term.times.empty()) continue;
        const std::uint64_t m = magnitude(term.x.m);
        Natural<fraction_limbs + 1> product;
        product.assign_product(term.times, {&m, 1});
        sum.add(product.limbs(), term.x.e, (term.x.m < 0) != term.is_negative);
    }
    return sum.over(den);
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

// Two fractions of 3k + 6 bits are compared in 6k + 12. Lengths alone decide most of the time.
int compare(const FractionRef& first, const FractionRef& second) noexcept {
    if (first.num.empty() || second.num.empty()) {
        return static_cast<int>(!first.num.empty()) - static_cast<int>(!second.num.empty());
    }
    const int difference =
        (bit_width(first.num) + bit_width(second.den)) - (bit_width(second.num) + bit_width(first.den));
    if (std::abs(difference) > 1) return difference < 0 ? -1 : 1;
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
    const double rounded = round_quotient(x.num, x.den, 0, false);
    return x.num.empty() ? 0 : std::bit_cast<double>(std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(rounded), 1));
}

Vec3 round_point_between(const Vec3& a, const Vec3& b, bool is_direction, const FractionRef& at) noexcept {
    Vec3 result;
    for (int k = 0; k < 3; ++k) {
        const Dyadic from = decode(a[k]), to = decode(b[k]);
        const std::array<Term, 3> terms{{{from, at.den, false}, {to, at.num, false}, {from, at.num, true}}};
        result[k] = round_coordinate(std::span(terms).first(is_direction ? 2 : 3), at.den);
    }
    return result;
}

}  // namespace ecods::exact
