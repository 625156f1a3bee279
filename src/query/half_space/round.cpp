#include "query/half_space/round.hpp"

#include <algorithm>
#include <limits>

#include "base/assert.hpp"
#include "base/outward.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::half_spaces {

using exact::Integer;
using exact::ScaledInteger;

namespace {

// Returns whole + length / sqrt(square).
exact::RootSum sum_of(const ScaledInteger& whole, const ScaledInteger& length, const ScaledInteger& square) {
    ECODS_ASSERT(square.e() % 2 == 0);
    exact::RootSum sum;
    sum.x = whole.m();
    sum.e = whole.e();
    sum.y = length.m() * length.m();
    sum.w = square.m();
    sum.f = length.e() - square.e() / 2;
    sum.is_subtracted = length.sign() < 0;
    return sum;
}

}  // namespace

double round_ratio(const ScaledInteger& length, const ScaledInteger& square, const ScaledInteger& more) {
    const exact::RootSum sum = sum_of(more, length, square);
    if (more.sign() == 0) {
        const double size = exact::round_root(sum.y.limbs(), sum.w.limbs(), sum.f);
        return sum.is_subtracted ? -size : size;
    }
    const double rounded = exact::round_root_sum(sum);
    if (magnitude_of(rounded) != 0) return rounded;
    return exact::sign(sum) * std::numeric_limits<double>::denorm_min();
}

int compare_ratio(const ScaledInteger& length, const ScaledInteger& square, const ScaledInteger& d) {
    return compare(length * length, d * d * square);
}

double round_quotient(const ScaledInteger& num, const ScaledInteger& den) {
    return exact::round_quotient(num.m().limbs(), den.m().limbs(), num.e() - den.e(), num.sign() * den.sign() < 0);
}

ExactPoint exact_point(const Vec3& v, const Pose& pose) {
    ExactPoint point;
    for (int k = 0; k < 3; ++k) {
        ScaledInteger& sum = point[static_cast<std::size_t>(k)];
        sum = ScaledInteger(pose.t[k]);
        for (int j = 0; j < 3; ++j) sum = sum + ScaledInteger(pose.R(k, j)) * ScaledInteger(v[j]);
    }
    return point;
}

Vec3 round_point(const ExactPoint& point) {
    const ScaledInteger one(1.0);
    return {round_quotient(point[0], one), round_quotient(point[1], one), round_quotient(point[2], one)};
}

Vec3 round_foot(const ExactPoint& point, const ScaledInteger& height, const Plane& plane) {
    const Plane::Exact& exact = plane.exact();
    Vec3 foot;
    for (std::size_t k = 0; k < 3; ++k) {
        foot[static_cast<Eigen::Index>(k)] =
            round_quotient(point[k] * exact.square - height * exact.N[k], exact.square);
    }
    return foot;
}

Vec3 round_lowest(const ExactPoint& center, const ScaledInteger& radius, const Plane& plane) {
    if (radius.sign() == 0) return round_point(center);
    const Plane::Exact& exact = plane.exact();
    Vec3 point;
    for (std::size_t k = 0; k < 3; ++k) {
        point[static_cast<Eigen::Index>(k)] =
            exact::round_root_sum(sum_of(center[k], -(radius * exact.N[k]), exact.square));
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
    const Integer whole = num.in_units(unit), divisor = den.in_units(unit);
    num_ = whole;
    den_ = divisor;
}

}  // namespace ecods::half_spaces
