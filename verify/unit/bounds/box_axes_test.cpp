// Boxes that share a point are never separated; most boxes that are well apart are.

#include "bounds/separating_axes.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "ecods/predicates.hpp"
#include "scenes/hard_pairs.hpp"

namespace ecods {
namespace {

// Boxes around the triangles of a pair that is known to meet.
TEST(SeparatingAxes, NeverSeparateTrianglesThatMeet) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        scenes::Random random(5);
        std::uint64_t separated = 0, apart = 0;
        for (const scenes::HardFamily family : scenes::hard_families()) {
            for (int i = 0; i < 1000; ++i) {
                const scenes::PosedPair pair = scenes::make_pair(family, random);
                const bool meet = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::disjoint;
                struct Box {
                    Vec3 center, half, magnitude;
                };
                const auto box_around = [](const std::array<Vec3, 3>& t) {
                    const Vec3 min = t[0].cwiseMin(t[1]).cwiseMin(t[2]), max = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
                    const Vec3 center = 0.5 * min + 0.5 * max;
                    Vec3 half = (max - center).cwiseMax(center - min);
                    for (int k = 0; k < 3; ++k) half[k] = std::nextafter(half[k], 1e308);
                    return Box{center, half, min.cwiseAbs().cwiseMax(max.cwiseAbs())};
                };
                const Box a = box_around(pair.a), b = box_around(pair.b);
                std::fesetround(mode);
                const SeparatingAxes axes(pair.pose_a.R, a.magnitude, pair.pose_b.R, b.magnitude,
                                          pair.pose_b.t - pair.pose_a.t);
                const bool separate = axes.separate(a.center, a.half, b.center, b.half);
                std::fesetround(FE_TONEAREST);
                ASSERT_FALSE(meet && separate) << scenes::name(family) << " " << i;
                separated += separate;
                apart += !meet;
            }
        }
        EXPECT_GT(separated, apart / 8) << "the test would be sound if it separated nothing";
    }
}

}  // namespace
}  // namespace ecods
