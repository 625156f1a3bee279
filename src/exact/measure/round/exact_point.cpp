#include "exact/measure/round/exact_point.hpp"

#include <cstdint>

#include "base/assert.hpp"
#include "exact/measure/round/natural_sum.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"

namespace ecods::exact {

// Returns coordinate `row` of R v + t + num / den 2^unit, rounded once. The coordinate is computed as a sum of products
// with den, divided by den.
double round_coordinate(const PointRef& origin, int row, const ExactPoint& point) noexcept {
    const ExactPoint::Coordinate& num = point.num[static_cast<std::size_t>(row)];
    const NaturalSpan den = point.den.limbs();
    const std::uint64_t one = 1;
    std::array<std::array<std::uint64_t, 2>, 4> sizes;
    std::array<Summand, 5> terms;
    const auto set = [&](std::size_t k, const Dyadic& a, const Dyadic& b) {
        const Uint128 size = Uint128{magnitude(a.m)} * magnitude(b.m);
        sizes[k] = {static_cast<std::uint64_t>(size), static_cast<std::uint64_t>(size >> 64)};
        terms[k] = {without_leading_zeros(sizes[k]), den, a.e + b.e, (a.m < 0) != (b.m < 0)};
    };
    for (int k = 0; k < 3; ++k) {
        set(static_cast<std::size_t>(k), decode(origin.pose->R(row, k)), decode((*origin.v)[k]));
    }
    set(3, decode(origin.pose->t[row]), {1, 0});
    terms[4] = {num.size.limbs(), {&one, 1}, point.unit, num.is_negative};
    return round_sum(terms, den);
}

Vec3 round_point(const PointRef& origin, const ExactPoint& point) noexcept {
    Vec3 result;
    for (int row = 0; row < 3; ++row) result[row] = round_coordinate(origin, row, point);
    return result;
}

namespace {

Integer numerator(const ExactPoint& p, std::size_t axis) {
    return {p.num[axis].size.limbs(), p.num[axis].is_negative};
}
Integer denominator(const ExactPoint& p) {
    return {p.den.limbs(), false};
}

}  // namespace

bool is_level(const ExactPoint& a, const ExactPoint& b, std::size_t axis) {
    ECODS_ASSERT(a.unit == b.unit);
    return numerator(a, axis) * denominator(b) == numerator(b, axis) * denominator(a);
}

ExactPoint middle_of(const ExactPoint& a, const ExactPoint& b) {
    ECODS_ASSERT(a.unit == b.unit);
    const Integer den_a = denominator(a), den_b = denominator(b);
    const bool is_common = den_a == den_b;
    ExactPoint middle;
    middle.unit = a.unit - 1;
    middle.den.assign((is_common ? den_a : den_a * den_b).limbs());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Integer x = numerator(a, axis), y = numerator(b, axis), sum = is_common ? x + y : x * den_b + y * den_a;
        middle.num[axis].size.assign(sum.limbs());
        middle.num[axis].is_negative = sum.sign() < 0;
    }
    return middle;
}

}  // namespace ecods::exact
