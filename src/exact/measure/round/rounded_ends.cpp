#include "exact/measure/round/rounded_ends.hpp"

#include <algorithm>

#include "exact/measure/round/round_root_sum.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

// Returns coordinate `row` of the point times its denominator, as m 2^e.
ExactSum::Scaled coordinate_of(const PointRef& origin, int row, const ExactPoint& point) {
    std::array<Dyadic, 4> left, right;
    for (int k = 0; k < 3; ++k) {
        left[static_cast<std::size_t>(k)] = decode(origin.pose->R(row, k));
        right[static_cast<std::size_t>(k)] = decode((*origin.v)[k]);
    }
    left[3] = decode(origin.pose->t[row]);
    right[3] = {1, 0};
    int unit = point.unit;
    for (std::size_t k = 0; k < 4; ++k) {
        if (left[k].m != 0 && right[k].m != 0) unit = std::min(unit, left[k].e + right[k].e);
    }
    Integer whole;
    for (std::size_t k = 0; k < 4; ++k) {
        if (left[k].m == 0 || right[k].m == 0) continue;
        whole = whole + (Integer(Int128{left[k].m} * right[k].m) << (left[k].e + right[k].e - unit));
    }
    const ExactPoint::Coordinate& num = point.num[static_cast<std::size_t>(row)];
    return {
        whole * Integer(point.den.limbs(), false) + (Integer(num.size.limbs(), num.is_negative) << (point.unit - unit)),
        unit};
}

}  // namespace

// The coordinate is x / den + radius n_i / |n| = x / den +- sqrt((radius n_i)^2 / n.n).
Vec3 round_end(const PointRef& origin, const ExactPoint& point, double radius, const LongDirection& n) {
    Vec3 result;
    const Dyadic r = decode(radius);
    for (int row = 0; row < 3; ++row) {
        const Integer& along = n.x[static_cast<std::size_t>(row)];
        RootSum sum;
        auto [x, e] = coordinate_of(origin, row, point);
        sum.x = std::move(x);
        sum.e = e;
        sum.z = Integer(point.den.limbs(), false);
        sum.y = along * along * Integer(Int128{r.m} * r.m);
        sum.w = n.square;
        sum.f = r.e;
        sum.is_subtracted = along.sign() < 0;
        result[row] = round_root_sum(sum);
    }
    return result;
}

}  // namespace ecods::exact
