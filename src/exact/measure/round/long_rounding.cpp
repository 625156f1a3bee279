#include "exact/measure/round/long_rounding.hpp"

#include "exact/measure/round/round_root_sum.hpp"
#include "exact/measure/round/squared_distance.hpp"

namespace ecods::exact {

double round_quotient(const ScaledInteger& num, const ScaledInteger& den) {
    const int e = num.e() - den.e();
    if (den.m().limbs().size() <= divisor_limbs) {
        return round_quotient(num.m().limbs(), den.m().limbs(), e, num.sign() * den.sign() < 0);
    }
    RootSum sum;
    sum.x = den.sign() < 0 ? -num.m() : num.m();
    sum.z = Integer(den.m().limbs(), false);
    sum.e = e;
    return round_root_sum(sum);
}

Vec3 round_point(const ScaledLongVector& num, const ScaledInteger& den) {
    return {round_quotient(num[0], den), round_quotient(num[1], den), round_quotient(num[2], den)};
}

Vec3 round_direction(const ScaledLongVector& v) {
    const ScaledInteger square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];  // in the least unit of the three
    const Integer one(std::int64_t{1});
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        double& rounded = result[static_cast<Eigen::Index>(k)];
        if (square.m().limbs().size() <= divisor_limbs) {
            const Integer of_one = (v[k] * v[k]).in_units(square.e());
            rounded = round_cosine(of_one.limbs(), square.m().limbs(), v[k].sign() < 0);
        } else {
            rounded = round_root_sum(root_sum({}, one, v[k], square));
        }
    }
    return result;
}

}  // namespace ecods::exact
