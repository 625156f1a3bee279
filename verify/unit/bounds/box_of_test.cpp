#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "ecods/primitives.hpp"
#include "oracle/oracle.hpp"
#include "scenes/each_case.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"

namespace ecods::box_of_test {
namespace {

using scenes::one_triangle;

// The error that box_of promises: 18 u (|R| v_max + |t|), on the axis where that is largest.
double promised_excess(const std::array<Vec3, 3>& corners, const Pose& pose) {
    const Vec3 v_max = corners[0].cwiseAbs().cwiseMax(corners[1].cwiseAbs()).cwiseMax(corners[2].cwiseAbs());
    return 18 * 0x1p-53 * (pose.R.cwiseAbs() * v_max + pose.t.cwiseAbs()).maxCoeff() + 0x1p-990;
}

TEST(BoxOf, ContainsTheExactBodyInEveryRoundingModeAndIsTight) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        scenes::Random random(3);
        scenes::for_each_case(scenes::hard_families(), random, 200, [&](const scenes::PosedPair& pair) {
            const auto mesh = one_triangle(pair.a);
            std::fesetround(mode);
            const Aabb box = box_of(*mesh, pair.pose_a);
            std::fesetround(FE_TONEAREST);
            const oracle::OracleMesh exact(mesh, pair.pose_a);
            ASSERT_TRUE(oracle::box_contains(box, exact));
            const double excess = promised_excess(pair.a, pair.pose_a);
            if (!(excess < std::numeric_limits<double>::max())) return;
            for (int k = 0; k < 3; ++k) {
                // The oracle's own box is around the exact one by some units in the last place.
                ASSERT_LE(exact.outer_box().min[k] - box.min[k], excess);
                ASSERT_LE(box.max[k] - exact.outer_box().max[k], excess);
            }
        });
    }
}

TEST(BoxOf, UnusedVerticesDoNotBelong) {
    const auto mesh = Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {100, 100, 100}}, {{0, 1, 2}});
    EXPECT_LT(box_of(*mesh, Pose()).max.maxCoeff(), 1.001);
}

TEST(BoxOf, IsInfiniteOnlyBeyondTheLargestDouble) {
    const double max = std::numeric_limits<double>::max();
    const auto mesh = one_triangle({Vec3(max, max, 0), Vec3(-max, 0, 0), Vec3(0, max, 1)});
    Pose pose;
    pose.R *= 4;
    const Aabb box = box_of(*mesh, pose);
    EXPECT_EQ(box.min[0], -std::numeric_limits<double>::infinity());
    EXPECT_EQ(box.max[1], std::numeric_limits<double>::infinity());
    EXPECT_LE(std::abs(box.min[1]), promised_excess({Vec3(max / 4, 0, 0), Vec3::Zero(), Vec3::Zero()}, pose) * 4);
    EXPECT_LT(box.max[2], 1e295);
}

TEST(BoxOf, ALongThinRotatedBoxIsTight) {
    std::vector<Vec3> vertices;
    for (int i = 0; i < 8; ++i) vertices.emplace_back(i & 1 ? 5 : -5, i & 2 ? 0.05 : -0.05, i & 4 ? 0.05 : -0.05);
    const auto mesh = Mesh::create(vertices, {{0, 1, 2}, {3, 4, 5}, {6, 7, 0}});
    Pose pose;
    const double angle = 0x1p-10;
    pose.R << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    const Vec3 size = box_of(*mesh, pose).max - box_of(*mesh, pose).min;
    EXPECT_NEAR(size[0], 10, 0.001);
    EXPECT_NEAR(size[1], 0.11, 0.001);
    EXPECT_NEAR(size[2], 0.1, 0.001);
}

TEST(Aabb, OverlapIsClosed) {
    const Aabb a{Vec3(0, 0, 0), Vec3(1, 1, 1)}, b{Vec3(1, 1, 1), Vec3(2, 2, 2)};
    EXPECT_TRUE(overlap(a, b));
    EXPECT_TRUE(overlap(b, a));
    const Aabb c{Vec3(std::nextafter(1.0, 2.0), 0, 0), Vec3(2, 1, 1)};
    EXPECT_FALSE(overlap(a, c));
    EXPECT_TRUE(contains(merge(a, b), a));
    EXPECT_FALSE(contains(a, merge(a, b)));
}

}  // namespace
}  // namespace ecods::box_of_test
