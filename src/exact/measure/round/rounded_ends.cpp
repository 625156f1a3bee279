#include "exact/measure/round/rounded_ends.hpp"

#include "exact/measure/round/round_root_sum.hpp"
#include "exact/point/posed_point.hpp"

namespace ecods::exact {

// Rounds each coordinate of the core's closest point plus radius n / |n|. In units of the RootSum it is x / den +
// radius n_i / |n|, where x / den is the core's coordinate.
Vec3 round_end(const PointRef& origin, const ExactPoint& point, const ScaledInteger& radius, const LongDirection& n) {
    const ScaledLongVector start = posed_point(*origin.pose, *origin.v);
    const Integer den(point.den.limbs(), false);
    const ScaledInteger scaled_den(den, 0), square(n.square, 0);
    Vec3 result;
    for (std::size_t row = 0; row < 3; ++row) {
        const ScaledInteger num(Integer(point.num[row].size.limbs(), point.num[row].is_negative), point.unit);
        const ScaledInteger along = radius * ScaledInteger(n.x[row], 0);
        result[static_cast<Eigen::Index>(row)] =
            round_root_sum(root_sum(start[row] * scaled_den + num, den, along, square));
    }
    return result;
}

}  // namespace ecods::exact
