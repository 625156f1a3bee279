// What two triangles share: its corners against the oracle, its normal where the answer is known by construction.

#include <gtest/gtest.h>

#include <bit>
#include <optional>

#include "measured_pairs.hpp"
#include "oracle/distance.hpp"
#include "oracle_pair.hpp"
#include "query/distance/triangle_distances.hpp"

namespace ecods::exact::shared_set_test {
namespace {

TEST(SharedSet, CornersAndNormalsAreThoseOfTheOracle) {
    TriangleDistances bodies;
    std::array<int, 7> counts{}, normal_counts{};
    Random random(16);
    const auto check = [&](const std::string& name, const PosedPair& pair) {
        const OnePair meshes(pair);
        const OraclePair truth(pair);
        const std::vector<oracle::ExactIntersection> all = truth->intersections();
        const oracle::ExactIntersection expected = all.empty() ? oracle::ExactIntersection() : all.front();
        for (const int environment : environments) {
            const SharedSet shared = in_environment(environment, [&] {
                bodies.bind(meshes.a(), meshes.b());
                return bodies.intersection(0, 0);
            });
            ASSERT_EQ(shared.corner_count, expected.corners.size()) << name;
            for (std::size_t i = 0; i < shared.corner_count; ++i) {
                ASSERT_TRUE(same_bits(shared.corners()[i], expected.corners[i].nearest())) << name << " corner " << i;
            }
            ASSERT_EQ(shared.normal.has_value(), expected.normal.has_value()) << name;
            ASSERT_TRUE(!shared.normal || same_bits(*shared.normal, expected.normal->nearest())) << name;
        }
        ++counts[expected.corners.size()];
        normal_counts[expected.corners.size()] += expected.normal.has_value();
    };
    for_each_pair(100, check);
    for (int i = 0; i < 3000; ++i) {
        check("in one plane", parallel_pair(random, false, 0));
        check("in one rotated plane", parallel_pair(random, true, 0));
    }
    for (const int count : counts) EXPECT_GT(count, 50);
    for (std::size_t i = 1; i < 7; ++i) EXPECT_GT(normal_counts[i], 50) << i;
}

struct KnownNormal {
    std::string name;
    std::array<Vec3, 3> a, b;
    std::optional<Vec3> normal;
};

TEST(SharedSet, NormalsAreThoseOfFacesAndOfCrossingEdges) {
    const std::array<Vec3, 3> floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const std::array<Vec3, 3> ceiling{Vec3(0, 0, 0), Vec3(0, 4, 0), Vec3(4, 0, 0)};
    const Vec3 up(0, 0, 1);
    const std::vector<KnownNormal> cases{
        {"vertex on face", {Vec3(1, 1, 0), Vec3(1, 1, 3), Vec3(1, 2, 3)}, floor, up},
        {"face under vertex", floor, {Vec3(1, 1, 0), Vec3(1, 1, 3), Vec3(1, 2, 3)}, up},
        {"face seen from below", ceiling, {Vec3(1, 1, 0), Vec3(1, 1, 3), Vec3(1, 2, 3)}, -up},
        {"edge on face", {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 3)}, floor, up},
        {"edge on face, beyond it", {Vec3(-1, 1, 0), Vec3(9, 1, 0), Vec3(1, 1, 3)}, floor, up},
        {"two faces", floor, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)}, up},
        {"two faces, the first turned", ceiling, floor, -up},
        {"edge half on face", floor, {Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(1, 0, 3)}, up},
        {"edges that touch",
         {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(2, 0, -4)},
         {Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(1, 0, 3)},
         up},
        {"vertex on vertex", floor, {Vec3(0, 0, 0), Vec3(-1, 0, 3), Vec3(0, -1, 3)}, std::nullopt},
        {"vertex on edge", floor, {Vec3(1, 0, 0), Vec3(1, -1, 3), Vec3(1, -1, 4)}, std::nullopt},
        {"edge along edge", floor, {Vec3(1, 0, 0), Vec3(9, 0, 0), Vec3(1, -1, 3)}, std::nullopt},
        {"faces that cross", floor, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(2, 2, 1)}, std::nullopt},
        {"apart", floor, {Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 2, 1)}, std::nullopt},
        {"segment on face", {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 0)}, floor, up},
        {"segment along edge", {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)}, floor, std::nullopt},
        {"segment through face", {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 0.5)}, floor, std::nullopt},
        {"segments that cross",
         {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 0, 0)},
         {Vec3(2, -1, 0), Vec3(2, 4, 0), Vec3(2, -1, 0)},
         up},
    };
    TriangleDistances bodies;
    for (const KnownNormal& c : cases) {
        PosedPair pair{};
        pair.a = c.a;
        pair.b = c.b;
        const OnePair meshes(pair);
        bodies.bind(meshes.a(), meshes.b());
        const SharedSet shared = bodies.intersection(0, 0);
        EXPECT_EQ(shared.corner_count == 0, c.name == "apart");
        ASSERT_EQ(shared.normal.has_value(), c.normal.has_value()) << c.name;
        EXPECT_TRUE(!c.normal || *shared.normal == *c.normal) << c.name;
    }
}

// Of oblique faces: each coordinate is the nearest double, in every environment.
TEST(SharedSet, NormalsAreRoundedOnce) {
    Random random(17);
    TriangleDistances bodies;
    for (int i = 0; i < 300; ++i) {
        PosedPair pair = parallel_pair(random, true, 0);
        const OnePair meshes(pair);
        const auto corner = [&](std::size_t k) { return rational(pair.pose_a, pair.a[k]); };
        const RationalPoint n = cross(corner(1) - corner(0), corner(2) - corner(0));
        bodies.bind(meshes.a(), meshes.b());
        if (bodies.intersection(0, 0).corner_count < 3) continue;
        for (const int environment : environments) {
            const SharedSet shared = in_environment(environment, [&] {
                bodies.bind(meshes.a(), meshes.b());
                return bodies.intersection(0, 0);
            });
            ASSERT_TRUE(shared.normal && is_direction(*shared.normal, n));
        }
    }
}

}  // namespace
}  // namespace ecods::exact::shared_set_test
