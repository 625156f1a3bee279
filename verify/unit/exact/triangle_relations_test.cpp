// The cached path of the narrow phase gives the answers of the plain one, by each of its stages.

#include "query/intersection/triangle_relations.hpp"

#include <gtest/gtest.h>

#include "ecods/mesh.hpp"
#include "scenes/each_case.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"

namespace ecods::exact::triangle_relations_test {
namespace {

using scenes::one_triangle;

TEST(TriangleRelations, AgreesWithThePredicateOnEveryFamily) {
    scenes::Random random(11);
    TriangleRelations bodies;
    scenes::for_each_case(scenes::hard_families(), random, 3000, [&](const scenes::PosedPair& pair) {
        const auto a = one_triangle(pair.a), b = one_triangle(pair.b);
        const MeshExtent extent_a = measure(*a), extent_b = measure(*b);
        bodies.bind({a.get(), &extent_a, &pair.pose_a}, {b.get(), &extent_b, &pair.pose_b});
        const Relation expected = triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b});
        ASSERT_EQ(bodies.relation(0, 0), expected);
        ASSERT_EQ(bodies.relation(0, 0), expected) << "from the cache";
        bodies.bind({b.get(), &extent_b, &pair.pose_b}, {a.get(), &extent_a, &pair.pose_a});
        ASSERT_EQ(bodies.relation(0, 0), expected);
    });
    const StageCounts& counts = bodies.counts();
    EXPECT_GT(counts.filter_passes, 0u);
    EXPECT_GT(counts.local_passes, 0u);
    EXPECT_GT(counts.one_limb, 0u);
    EXPECT_GT(counts.two_limbs, 0u);
    EXPECT_GT(counts.many_limbs, 0u);
    EXPECT_EQ(counts.triangle_tests, counts.filter_passes + counts.semi_static_passes + counts.local_passes +
                                         counts.one_limb + counts.two_limbs + counts.many_limbs);
}

// Meshes with more vertices than the caches hold, so that entries are replaced.
TEST(TriangleRelations, CachesMayOverflow) {
    const auto mesh = scenes::sphere(60, 60);
    const MeshExtent extent = measure(*mesh);
    Pose pose_a, pose_b;
    pose_b.t = Vec3(0.5, 0.25, 0.125);
    TriangleRelations bodies;
    bodies.bind({mesh.get(), &extent, &pose_a}, {mesh.get(), &extent, &pose_b});
    const auto corners = [&](std::size_t t) {
        const Triangle& triangle = mesh->triangles()[t];
        return std::array<Vec3, 3>{mesh->vertices()[triangle[0]], mesh->vertices()[triangle[1]],
                                   mesh->vertices()[triangle[2]]};
    };
    for (std::uint32_t i = 0; i < mesh->triangles().size(); i += 7) {
        for (std::uint32_t j = 0; j < mesh->triangles().size(); j += 31) {
            ASSERT_EQ(bodies.relation(i, j), triangle_triangle({pose_a, corners(i)}, {pose_b, corners(j)}));
        }
    }
}

// Both bodies under the same bits of a regular pose: decided where they were modelled. Short coordinates: in plain
// double.
TEST(TriangleRelations, ShortcutsAreTaken) {
    const auto cube = scenes::cube(0.5);
    const MeshExtent extent = measure(*cube);
    Pose a, b;
    b.t = Vec3(1, 0, 0);
    TriangleRelations bodies;
    bodies.bind({cube.get(), &extent, &a}, {cube.get(), &extent, &b});
    for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t j = 0; j < 12; ++j) bodies.relation(i, j);
    }
    EXPECT_EQ(bodies.counts().one_limb + bodies.counts().two_limbs + bodies.counts().many_limbs, 0u);
    EXPECT_GT(bodies.counts().local_passes, 0u);
}

}  // namespace
}  // namespace ecods::exact::triangle_relations_test
