// The points of two triangles in the narrowest integers that hold them: what all exact questions begin with.
#pragma once

#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/point/integer_points.hpp"
#include "query/distance/triangle_distances.hpp"
#include "simd/inline.hpp"

namespace ecods {

ECODS_ALWAYS_INLINE exact::IntegerPair TriangleDistances::integers(std::uint32_t i, std::uint32_t j) {
    exact::IntegerPair pair;
    for (std::size_t k = 0; k < 3; ++k) {
        pair.at[k] = points_.at(0, triangles_[0][i][k]);
        pair.at[3 + k] = points_.at(1, triangles_[1][j][k]);
    }
    pair.unit = points_.unit();
    pair.error = points_.is_exact() ? 0 : exact::FixedPoints::error_units;
    return pair;
}

// Calls use(points, features, guess) with the points of two triangles in the narrowest kernel that holds them. A guess
// that doubles prove is not asked about again.
template <class Use>
auto TriangleDistances::with_features(std::uint32_t i, std::uint32_t j, Use&& use) {
    const exact::IntegerPair pair = integers(i, j);
    const exact::FeaturePair features = exact::guess_features(pair);
    const bool is_certain = exact::enclose_distance(pair, features).is_certain;
    const exact::ClosestFeatures guess{features, is_certain ? exact::Standing::only : exact::Standing::none};
    const auto in_kernel = [&]<class Kernel>(const exact::IntegerPoints<Kernel, 6>& points) {
        const auto limbs = exact::to_limbs(points);
        return use(points, exact::ExactFeatures<exact::limbs_of<Kernel>>(limbs), guess);
    };
    if (points_.is_exact())
        return exact::use_narrowest(exact::IntegerPoints<exact::TwoLimbKernel, 6>{pair.at, pair.unit}, in_kernel);
    exact::PosedPoints<6> posed;
    for (std::size_t k = 0; k < 3; ++k) {
        const exact::BodyRef &a = points_.body(0), &b = points_.body(1);
        posed[k] = {a.pose, &a.mesh->vertices()[triangles_[0][i][k]]};
        posed[3 + k] = {b.pose, &b.mesh->vertices()[triangles_[1][j][k]]};
    }
    return exact::with_integers(posed, in_kernel);
}

}  // namespace ecods
