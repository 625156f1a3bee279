// Converts the points of two hulls' features to exact integers.
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "query/convex/closest_hulls.hpp"

namespace ecods::convex {

// Calls use(points, features, limbs) with the exact points of N >= 6 vertices, in the narrowest kernel that holds them.
// `features` has the exact features of two triangles: the first three points, and the next three. `limbs` has all N
// points.
template <std::size_t N, class Use>
auto with_exact_features(PosedHulls& hulls, const std::array<HullVertex, N>& vertices, Use&& use) {
    static_assert(N >= 6);
    return hulls.with_integers(vertices, [&]<class Kernel>(const exact::IntegerPoints<Kernel, N>& points) {
        constexpr int L = Kernel::limb_count;
        const auto limbs = exact::to_limbs(points);
        std::array<typename exact::ExactFeatures<L>::Point, 6> six;
        for (std::size_t i = 0; i < 6; ++i) six[i] = limbs[i];
        return use(points, exact::ExactFeatures<L>(six), limbs);
    });
}

}  // namespace ecods::convex
