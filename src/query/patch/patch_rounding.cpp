#include "query/patch/patch_rounding.hpp"

#include <array>

#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "query/convex/exact_hulls.hpp"

namespace ecods::patches {
namespace {

using exact::Integer;

// Returns num / den + along n / |n|, with n the normal; each coordinate is rounded once.
Vec3 round_point(const ScaledLongVector& num, const ScaledInteger& den, const ScaledInteger& along,
                 const ExactNormal& normal) {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const ScaledInteger& x = num[k];
        double& rounded = result[static_cast<Eigen::Index>(k)];
        if (along.sign() == 0 && den.m().limbs().size() <= exact::divisor_limbs) {
            rounded = exact::round_quotient(x.m().limbs(), den.m().limbs(), x.e() - den.e(), x.sign() < 0);
        } else {
            const ScaledInteger whole(x.m(), x.e() - den.e());
            rounded = exact::round_root_sum(exact::root_sum(whole, den.m(), along * normal.n[k], normal.square));
        }
    }
    return result;
}

ScaledLongVector sum_over_common(const LongPoint& x, const LongPoint& y) {
    ScaledLongVector sum;
    for (std::size_t k = 0; k < 3; ++k) sum[k] = x.num[k] * y.den + y.num[k] * x.den;
    return sum;
}

// Returns the difference (gap of the cores) - (sum of the radii) - d.
exact::RootSum gap_beyond(const LongCorner& exact, const Reach& reach, const ExactNormal& normal, double d) {
    return exact::root_sum(-reach.sum.plus(d).scaled(), Integer(std::int64_t{1}), exact.num,
                           exact.den * exact.den * normal.square);
}

}  // namespace

void round_least(convex::PosedHulls& hulls, const HullFeaturePair& pair, const Reach& reach, const ExactNormal& normal,
                 PatchCorner& corner) {
    const convex::HullFeatures found = convex::features_of(hulls, pair);
    const exact::PointRef origin = hulls.reference({0, found.corners[0][0]});
    std::array<exact::ExactPoint, 2> ends;
    with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        exact::find_closest_points(features, found.features, points.unit, ends);
    });
    const exact::ExactPoint middle = exact::middle_of(ends[0], ends[1]);
    if (reach.sum.sign() == 0) {
        const exact::ExactPoint& simple = ends[pair[0].kind == Feature::Kind::vertex ? 0 : 1];
        for (int row = 0; row < 3; ++row) {
            // A coordinate on an axis across the normal is often the same in both points; then it is rounded only once.
            if (exact::is_level(ends[0], ends[1], static_cast<std::size_t>(row))) {
                corner.point_a[row] = corner.point_b[row] = corner.middle[row] =
                    exact::round_coordinate(origin, row, simple);
                continue;
            }
            corner.point_a[row] = exact::round_coordinate(origin, row, ends[0]);
            corner.point_b[row] = exact::round_coordinate(origin, row, ends[1]);
            corner.middle[row] = exact::round_coordinate(origin, row, middle);
        }
        return;
    }
    const exact::LongDirection n{{normal.n[0].m(), normal.n[1].m(), normal.n[2].m()}, normal.square.m()};
    corner.point_a = exact::round_end(origin, ends[0], reach.of_a, n);
    corner.point_b = exact::round_end(origin, ends[1], reach.of_b, n);
    corner.middle = exact::round_end(origin, middle, reach.of_middle, n);
}

void round_corner(const LongCorner& exact, const Reach& reach, const ExactNormal& normal, PatchCorner& corner) {
    const auto& [x, y] = exact.at;
    const ScaledInteger den = x.den * y.den, twice(den.m(), den.e() + 1);
    corner.point_a = round_point(x.num, x.den, reach.of_a, normal);
    corner.point_b = round_point(y.num, y.den, reach.of_b, normal);
    corner.middle = round_point(sum_over_common(x, y), twice, reach.of_middle, normal);
    corner.gap = exact::round_signed(gap_beyond(exact, reach, normal, 0));
}

int compare_gap(const LongCorner& exact, const Reach& reach, const ExactNormal& normal, double d) {
    return exact::sign(gap_beyond(exact, reach, normal, d));
}

}  // namespace ecods::patches
