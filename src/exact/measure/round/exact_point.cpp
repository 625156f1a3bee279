#include "exact/measure/round/exact_point.hpp"

#include <cstdint>

#include "exact/measure/round/natural_sum.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

// A term of a coordinate: size * 2^e.
struct Term {
    std::array<std::uint64_t, 2> limbs;
    int e;
    bool is_negative;
};

Term product(const Dyadic& a, const Dyadic& b) noexcept {
    const Uint128 size = Uint128{magnitude(a.m)} * magnitude(b.m);
    return {
        {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)}, a.e + b.e, (a.m < 0) != (b.m < 0)};
}

// Terms times a denominator are below 2^2050 times it and multiples of 2^-2148, and so are numerators: limb_count_max
// limbs for what the denominator is multiplied by, and a bit for the sign.
using Sum = NaturalSum<5 * limb_count_max + 2>;

double round_coordinate(const PointRef& origin, int row, const ExactPoint& point) noexcept {
    const Dyadic one{1, 0};
    std::array<Term, 4> terms;
    for (int k = 0; k < 3; ++k) {
        terms[static_cast<std::size_t>(k)] = product(decode(origin.pose->R(row, k)), decode((*origin.v)[k]));
    }
    terms[3] = product(decode(origin.pose->t[row]), one);

    const ExactPoint::Coordinate& num = point.num[static_cast<std::size_t>(row)];
    const NaturalSpan den = point.den.limbs();
    BitRange range;
    if (!num.size.is_zero()) range.include(point.unit, point.unit + bit_width(num.size.limbs()));
    for (const Term& term : terms) {
        const int width = bit_width(without_leading_zeros(term.limbs));
        if (width > 0) range.include(term.e, term.e + width + bit_width(den));
    }
    if (range.empty()) return 0;
    Sum sum(range.low, range.high);
    if (!num.size.is_zero()) sum.add(num.size.limbs(), point.unit, num.is_negative);
    for (const Term& term : terms) {
        const NaturalSpan limbs = without_leading_zeros(term.limbs);
        if (limbs.empty()) continue;
        Natural<denominator_limbs + 2> times_den;
        times_den.assign_product(den, limbs);
        sum.add(times_den.limbs(), term.e, term.is_negative);
    }
    return sum.over(den);
}

}  // namespace

Vec3 round_point(const PointRef& origin, const ExactPoint& point) noexcept {
    Vec3 result;
    for (int row = 0; row < 3; ++row) result[row] = round_coordinate(origin, row, point);
    return result;
}

}  // namespace ecods::exact
