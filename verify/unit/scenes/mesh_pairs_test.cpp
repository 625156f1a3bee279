#include "scenes/mesh_pairs.hpp"

#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "pose_digest.hpp"
#include "scenes/fitted_parts.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {
namespace {

bool is_hit(const MeshPairs& pairs, const MeshQuery& query) {
    const auto body = [&](const MeshAt& at) { return oracle::OracleMesh(pairs.meshes[at.mesh_index].mesh, at.pose); };
    return oracle::intersects(body(query.a), body(query.b));
}

// Every other query hits, the first included; the oracle says so.
void expect_every_other(const MeshPairs& pairs) {
    for (std::size_t i = 0; i < pairs.queries.size(); ++i)
        EXPECT_EQ(is_hit(pairs, pairs.queries[i]), i % 2 == 0) << pairs.name << ", query " << i;
}

std::uint64_t digest(const MeshPairs& pairs) {
    Scene scene;
    for (const MeshQuery& query : pairs.queries) {
        scene.bodies.push_back({"", 0, query.a.pose});
        scene.bodies.push_back({"", 0, query.b.pose});
    }
    return pose_digest(scene);
}

TEST(MeshPairs, HalfOfTheNearOnesHit) {
    const MeshPairs pairs = near_pairs("ship", ship(), 40, 1);
    ASSERT_EQ(pairs.queries.size(), 40u);
    expect_every_other(pairs);
}

TEST(MeshPairs, GapsAreKeptDownToAdjacentDoubles) {
    for (const double gap : {1e-3, 1e-9, 1e-15, 0.0}) expect_every_other(gap_pairs("ship", ship(), gap, 10, 2));
}

TEST(MeshPairs, RandomOnesHitAndMiss) {
    const MeshPairs pairs = random_pairs("ship", ship(), 200, 3);
    std::size_t hits = 0;
    for (const MeshQuery& query : pairs.queries) hits += is_hit(pairs, query) ? 1 : 0;
    EXPECT_GT(hits, 5u);
    EXPECT_LT(hits, 100u);
}

TEST(MeshPairs, FittedPartsTouchOrAreParted) {
    expect_every_other(stacked_bricks(24, 1));
    expect_every_other(splined_shafts(8, 1));
}

TEST(MeshPairs, FittedPartsHaveTheSizesThatAreTold) {
    EXPECT_EQ(stacked_bricks(1, 1).meshes[0].mesh->triangles().size(), 192u);
    const MeshPairs shafts = splined_shafts(1, 1);
    EXPECT_EQ(shafts.meshes[0].mesh->triangles().size(), 1536u);
    EXPECT_EQ(shafts.meshes[1].mesh->triangles().size(), 1536u);
}

// The poses themselves, bit for bit: benchmarks of different machines ask the same queries.
TEST(MeshPairs, AreTheSameOnEveryMachine) {
    EXPECT_EQ(digest(near_pairs("cube", cube(1), 20, 1)), 2515188955504354121u);
    EXPECT_EQ(digest(gap_pairs("cube", cube(1), 0, 20, 1)), 15832812549893373833u);
    EXPECT_EQ(digest(random_pairs("cube", cube(1), 20, 1)), 16591756989461074493u);
    EXPECT_EQ(digest(splined_shafts(20, 1)), 14421865766491031837u);
}

}  // namespace
}  // namespace ecods::scenes
