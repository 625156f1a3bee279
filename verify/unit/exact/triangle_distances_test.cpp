// Distances, comparisons and closest points of pairs of triangles are those of the oracle, to the last bit and in every
// floating-point environment.

#include "query/distance/triangle_distances.hpp"

#include <gtest/gtest.h>

#include "base/next.hpp"
#include "ecods/primitives.hpp"
#include "measured_pairs.hpp"
#include "oracle/distance.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::triangle_distances_test {
namespace {

TEST(TriangleDistances, AreRoundedOnceInEveryEnvironment) {
    TriangleDistances bodies;
    for_each_pair(150, [&](const std::string& name, const PosedPair& pair) {
        const OnePair meshes(pair);
        const OraclePair truth(pair);
        const double expected = oracle::nearest(truth->distance());
        ASSERT_EQ(bits(expected) == 0,
                  triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::apart);
        for (const int environment : environments) {
            const double d = in_environment(environment, [&] {
                bodies.bind(meshes.a(), meshes.b());
                return bodies.distance(0, 0);
            });
            ASSERT_EQ(bits(d), bits(expected)) << name << " " << environment << " " << d << " " << expected;
        }
    });
}

TEST(TriangleDistances, AreComparedWithDoublesExactly) {
    TriangleDistances bodies;
    int equal_count = 0;
    for_each_pair(100, [&](const std::string& name, const PosedPair& pair) {
        const OnePair meshes(pair);
        const OraclePair truth(pair);
        const oracle::ExactRoot root = truth->distance();
        const double d = oracle::nearest(root);
        bodies.bind(meshes.a(), meshes.b());
        const double inf = std::numeric_limits<double>::infinity();
        for (const double x : {d, d == 0 ? 0 : next_down(d), next_up(d), 2 * d, d / 2, 0.0, 0x1p-1074, 0x1p1023, inf}) {
            const int expected = oracle::compare(root, x);
            for (const int environment : environments) {
                const int sign = in_environment(environment, [&] { return bodies.compare(0, 0, x); });
                ASSERT_EQ(sign, expected) << name << " " << x;
            }
            equal_count += expected == 0;
        }
    });
    EXPECT_GT(equal_count, 1000);
}

bool same(const Feature& feature, const oracle::NamedFeature& expected) {
    return static_cast<int>(feature.kind) == expected.dimension && feature.triangle == expected.triangle &&
           feature.corner == expected.corner;
}

TEST(TriangleDistances, ClosestPointsAreThoseOfTheRule) {
    TriangleDistances bodies;
    std::array<int, 5> counts{};
    for_each_pair(150, [&](const std::string& name, const PosedPair& pair) {
        const OnePair meshes(pair);
        const OraclePair truth(pair);
        const oracle::ExactClosest expected = truth->closest(0, 0);
        for (const int environment : environments) {
            std::vector<FeatureNames> names;
            CloseFeatures features;
            const ClosestPoints c = in_environment(environment, [&] {
                bodies.bind(meshes.a(), meshes.b());
                bodies.add_features(0, 0, names);
                features = bodies.measure(names.front());
                return bodies.closest(0, 0);
            });
            ASSERT_EQ(static_cast<int>(c.kind), static_cast<int>(expected.kind)) << name;
            ASSERT_TRUE(same(c.a, expected.a) && same(c.b, expected.b)) << name << " " << static_cast<int>(c.kind);
            ASSERT_EQ(bits(c.distance), bits(oracle::nearest(expected.distance))) << name;
            ASSERT_TRUE(same_bits(c.point_a, expected.point_a.nearest())) << name << " " << static_cast<int>(c.kind);
            ASSERT_TRUE(same_bits(c.point_b, expected.point_b.nearest())) << name << " " << static_cast<int>(c.kind);
            ++counts[static_cast<std::size_t>(c.kind)];
            ASSERT_EQ(bits(features.closest.distance), bits(c.distance)) << name;
            if (c.kind == ClosestKind::intersecting) continue;
            ASSERT_EQ(names.front(), (FeatureNames{c.kind, c.a, c.b})) << name;
            ASSERT_TRUE(same_bits(features.closest.point_a, c.point_a) &&
                        same_bits(features.closest.point_b, c.point_b))
                << name;
            const RationalPoint gap = rational(expected.point_b) - rational(expected.point_a);
            ASSERT_TRUE(features.direction && is_direction(*features.direction, gap)) << name;
        }
    });
    for (const int count : counts) EXPECT_GT(count, 500);
}

// Two pairs of triangles of the same bodies: of equal distances, some of them of features of different kinds, and not.
TEST(TriangleDistances, AreComparedWithEachOtherExactly) {
    Random random(15);
    TriangleDistances bodies;
    std::array<int, 3> counts{};
    for (int i = 0; i < 3000; ++i) {
        const int exponent = i % 3 == 0 ? static_cast<int>(random.below(600)) - 300 : 0;
        const PosedPair first = scaled_by(parallel_pair(random, i % 2 == 0, 0.1 * (1 + random.below(2))), exponent);
        PosedPair second = scaled_by(parallel_pair(random, false, 0.1 * (1 + random.below(2))), exponent);
        if (i % 7 == 0) second = scaled_by(second, -static_cast<int>(random.below(200)));
        std::vector<Vec3> a(first.a.begin(), first.a.end()), b(first.b.begin(), first.b.end());
        a.insert(a.end(), second.a.begin(), second.a.end());
        b.insert(b.end(), second.b.begin(), second.b.end());
        const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
        const auto mesh_a = Mesh::create(a, triangles), mesh_b = Mesh::create(b, triangles);
        const MeshExtent extent_a = measure(*mesh_a), extent_b = measure(*mesh_b);
        bodies.bind({mesh_a.get(), &extent_a, &first.pose_a}, {mesh_b.get(), &extent_b, &first.pose_b});
        const oracle::MeshDistances truth({a, triangles, first.pose_a}, {b, triangles, first.pose_b});
        for (const TrianglePair x : {TrianglePair{0, 0}, {0, 1}, {1, 1}}) {
            for (const TrianglePair y : {TrianglePair{0, 0}, {0, 1}, {1, 1}}) {
                const int expected = compare(truth.distance(x.a, x.b), truth.distance(y.a, y.b));
                ASSERT_EQ(bodies.compare(x, y), expected);
                ++counts[static_cast<std::size_t>(expected + 1)];
            }
        }
    }
    EXPECT_GT(counts[1], 10000);
    EXPECT_GT(counts[0], 1000);
}

}  // namespace
}  // namespace ecods::exact::triangle_distances_test
