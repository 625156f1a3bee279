// No rank is above that of the distance, of nodes and of triangles, in any rounding mode.
#include "bvh/axes/far_gap.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/tree_body.hpp"

namespace ecods::far_gap_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Pair {
    Body a{scenes::torus(12, 8, 0.4)}, b{scenes::torus(12, 8, 0.3)};
    DistanceAxes axes;
    FarGap gap;

    void bind() {
        const Vec3 d = b.pose.t - a.pose.t;
        axes.bind(a.posed(), b.posed(), d);
        gap.bind(axes, a.posed(), b.posed(), d);
    }
};

// Whether the trees let the triangles through to the leaves, where nothing above the limit matters.
bool let_through(const Pair& pair, float limit, const TrianglePair& triangles) {
    alignas(32) LaneBounds ranks;
    const auto mask = [&](const auto& x, const auto& y) {
        return mask_of_all(ranks, [&](LaneBounds& numbers) { return far_mask(pair.gap, limit, x, y, numbers); });
    };
    return let_through(pair.a, pair.b, mask, triangles.a, triangles.b);
}

void expect_bounds(Pair& pair, const oracle::MeshDistances& truth, scenes::Random& random) {
    const auto count_a = static_cast<std::uint32_t>(pair.a.mesh->triangles().size());
    const auto count_b = static_cast<std::uint32_t>(pair.b.mesh->triangles().size());
    for (int i = 0; i < 60; ++i) {
        const TrianglePair triangles{random.below(count_a), random.below(count_b)};
        const double d = std::nextafter(nearest(truth.distance(triangles.a, triangles.b)), infinity);
        for (const int mode : rounding_modes) {
            std::fesetround(mode);
            pair.bind();
            const bool is_far = pair.gap.is_far();
            const bool found = is_far && let_through(pair, pair.gap.rank_above(d), triangles);
            const bool all = is_far && let_through(pair, pair.gap.rank_above(infinity), triangles);
            std::fesetround(FE_TONEAREST);
            ASSERT_TRUE(is_far);
            EXPECT_TRUE(found) << "rounding mode " << mode << ", " << d;
            EXPECT_TRUE(all) << "rounding mode " << mode << ", " << d;
        }
    }
}

TEST(FarGap, NoRankIsAboveThatOfTheDistance) {
    scenes::Random random(1);
    for (const double d : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e12}) {
        SCOPED_TRACE(d);
        for (int i = 0; i < 4; ++i) {
            Pair pair;
            pair.a.pose.R = random.rotation().toRotationMatrix();
            pair.b.pose.R = random.rotation().toRotationMatrix() * (i % 2 == 0 ? 1 : 1e-3);
            if (i == 3) pair.b.pose.R(0, 1) += 0.7;
            pair.a.pose.t = random.direction() * (i == 2 ? d : 0);
            pair.b.pose.t = pair.a.pose.t + random.direction() * d;
            const oracle::MeshDistances truth(pair.a.soup(), pair.b.soup());
            ASSERT_NO_FATAL_FAILURE(expect_bounds(pair, truth, random));
        }
    }
}

// At a distance at which squares are all the same in floats, ranks are not.
TEST(FarGap, RanksTellNodesApart) {
    Pair pair;
    pair.b.pose.t = Vec3(1e6, 0, 0);
    pair.bind();
    ASSERT_TRUE(pair.gap.is_far());
    const double step = 0x1p-10;
    const auto more = static_cast<double>(pair.gap.rank_above(1e6 + step) - pair.gap.rank_above(1e6));
    EXPECT_NEAR(more * pair.axes.unit(), step, 0x1p-6 * step);
    EXPECT_EQ(pair.gap.rank_above(0), 0);
}

TEST(FarGap, OnlyBodiesThatAreFar) {
    Pair pair;
    for (const double d : {0.0, 3.0, 30.0}) {
        pair.b.pose.t = Vec3(d, 0, 0);
        pair.bind();
        EXPECT_FALSE(pair.gap.is_far()) << d;
    }
    pair.b.pose.t = Vec3(1e4, infinity, 0);
    pair.bind();
    EXPECT_FALSE(pair.gap.is_far());
}

}  // namespace
}  // namespace ecods::far_gap_test
