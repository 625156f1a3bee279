// set_ends rounds the distance and the closest points of two features, or of two features that are rounded by radii.
#pragma once

#include <array>

#include "ecods/results.hpp"
#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/rounded_ends.hpp"

namespace ecods::exact {

// Sets the distance and both points of `result`. `ends` are the closest points of the features f, relative to `origin`,
// and `square` is their squared distance, which is not zero.
template <int L>
void set_ends(ClosestPoints& result, const SquaredDistance& square, const PointRef& origin,
              const std::array<ExactPoint, 2>& ends, const ExactFeatures<L>& features, const FeaturePair& f,
              const Radii& radii) {
    const ExactSum sum = radii.sum();
    if (sum.sign() == 0) {
        result.distance = round_root(square);
        result.point_a = round_point(origin, ends[0]);
        result.point_b = round_point(origin, ends[1]);
        return;
    }
    result.distance = round_beyond(square, sum);
    features.with_direction(f, [&]<int M>(const LimbVector<M>& n, bool is_turned) {
        result.point_a = round_end(origin, ends[0], radii.a, LongDirection::of<M>(n, is_turned));
        result.point_b = round_end(origin, ends[1], radii.b, LongDirection::of<M>(n, !is_turned));
    });
}

}  // namespace ecods::exact
