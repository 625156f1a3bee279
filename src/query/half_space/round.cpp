#include "query/half_space/round.hpp"

#include <algorithm>

#include "exact/measure/round/round_root_sum.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::half_spaces {

using exact::Integer;
using exact::ScaledInteger;
using exact::ScaledLongVector;

double round_ratio(const ScaledInteger& length, const ScaledInteger& square, const ScaledInteger& more) {
    const Integer one(std::int64_t{1});
    const exact::RootSum sum = exact::root_sum(more, one, length, square);
    if (more.sign() != 0) return exact::round_signed(sum);
    const double size = exact::round_root(sum.y.limbs(), sum.w.limbs(), sum.f);
    return sum.is_subtracted ? -size : size;
}

int compare_ratio(const ScaledInteger& length, const ScaledInteger& square, const ScaledInteger& d) {
    return compare(length * length, d * d * square);
}

double round_quotient(const ScaledInteger& num, const ScaledInteger& den) {
    return exact::round_quotient(num.m().limbs(), den.m().limbs(), num.e() - den.e(), num.sign() * den.sign() < 0);
}

Vec3 round_point(const ScaledLongVector& point) {
    const ScaledInteger one(1.0);
    return {round_quotient(point[0], one), round_quotient(point[1], one), round_quotient(point[2], one)};
}

Vec3 round_foot(const ScaledLongVector& point, const ScaledInteger& height, const Plane& plane) {
    const Plane::Exact& exact = plane.exact();
    Vec3 foot;
    for (std::size_t k = 0; k < 3; ++k) {
        foot[static_cast<Eigen::Index>(k)] =
            round_quotient(point[k] * exact.square - height * exact.N[k], exact.square);
    }
    return foot;
}

Vec3 round_lowest(const ScaledLongVector& center, const ScaledInteger& radius, const Plane& plane) {
    if (radius.sign() == 0) return round_point(center);
    const Plane::Exact& exact = plane.exact();
    const Integer one(std::int64_t{1});
    Vec3 point;
    for (std::size_t k = 0; k < 3; ++k) {
        point[static_cast<Eigen::Index>(k)] =
            exact::round_root_sum(exact::root_sum(center[k], one, -(radius * exact.N[k]), exact.square));
    }
    return point;
}

Vec3 round_inward(const Plane& plane) {
    const Plane::Exact& exact = plane.exact();
    Vec3 direction;
    for (std::size_t k = 0; k < 3; ++k) {
        direction[static_cast<Eigen::Index>(k)] = round_ratio(-exact.N[k], exact.square);
    }
    return direction;
}

Quotient::Quotient(const ScaledInteger& num, const ScaledInteger& den) {
    const int unit = std::min(num.sign() == 0 ? den.e() : num.e(), den.e());
    num_ = num.in_units(unit);
    den_ = den.in_units(unit);
}

}  // namespace ecods::half_spaces
