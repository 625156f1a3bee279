// Converts the points of two triangles to the narrowest integers that hold them, for exact queries.
#pragma once

#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/point/integer_points.hpp"
#include "query/distance/triangle_distances.hpp"
#include "simd/inline.hpp"

namespace ecods {

ECODS_ALWAYS_INLINE exact::IntegerPair TriangleDistances::integers(std::uint32_t i, std::uint32_t j) {
    const Triangle& a = triangles_[0][i];
    exact::IntegerPair pair = exact::integer_pair(points_, a, triangles_[1][j]);
    pair.first_is_point = a[0] == a[1] && a[0] == a[2];
    return pair;
}

// Calls use(points, features, guess) with the corners of two triangles as integers of the narrowest kernel that holds
// them. `guess` names the probable closest features. If doubles prove the guess, it is marked as certain, and integers
// need not prove it.
template <class Use>
auto TriangleDistances::with_features(std::uint32_t i, std::uint32_t j, Use&& use) {
    const exact::IntegerPair pair = integers(i, j);
    const exact::FeaturePair features = exact::guess_features(pair);
    const bool is_certain = exact::enclose_distance(pair, features).is_certain;
    const exact::ClosestFeatures guess{features, is_certain ? exact::Standing::only : exact::Standing::none};
    return points_.with_integers(exact::corners_of(triangles_[0][i], triangles_[1][j]),
                                 [&]<class Kernel>(const exact::IntegerPoints<Kernel, 6>& points) {
                                     const auto limbs = exact::to_limbs(points);
                                     return use(points, exact::ExactFeatures<Kernel::limb_count>(limbs), guess);
                                 });
}

}  // namespace ecods
