// Work is proportional to what moved: shown by counts.

#include <gtest/gtest.h>

#include "ecods/world.hpp"
#include "scenes/room.hpp"
#include "scenes/shapes.hpp"
#include "world_fixture.hpp"

namespace ecods {
namespace {

TEST(WorldWork, AFrameInWhichNothingMovedDoesNothing) {
    World world;
    const auto cube = scenes::cube(0.5);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 1000; ++i) bodies.push_back(world.create_body(cube, at(i % 10, i / 10 % 10, i / 100)));
    world.update();
    const Statistics before = world.statistics();
    world.update();
    world.set_pose(bodies[7], world.pose(bodies[7]));
    world.set_shape(bodies[8], world.shape(bodies[8]));
    world.update();
    const Statistics after = world.statistics();
    EXPECT_EQ(after.two_body_tests, before.two_body_tests);
    EXPECT_EQ(after.moved_bodies, before.moved_bodies);
    EXPECT_EQ(after.queries.queries, before.queries.queries);
    EXPECT_EQ(after.broad_phase.swaps, before.broad_phase.swaps);
    EXPECT_EQ(after.broad_phase.box_tests, before.broad_phase.box_tests);
    EXPECT_EQ(after.broad_phase.moved, before.broad_phase.moved);
    EXPECT_EQ(after.cache_hits, before.cache_hits + 2 * before.overlapping_count);
}

TEST(WorldWork, OneBodyThatMovedCostsItsOwnPairs) {
    World world;
    const auto cube = scenes::cube(0.5);
    std::vector<BodyId> bodies;
    for (int i = 0; i < 1000; ++i) bodies.push_back(world.create_body(cube, at(i % 10, i / 10 % 10, i / 100)));
    world.update();
    const Statistics before = world.statistics();
    world.set_pose(bodies[555], at(5, 5, 5.25));
    world.update();
    const Statistics after = world.statistics();
    EXPECT_EQ(after.moved_bodies, before.moved_bodies + 1);
    // The eight beside and nine above it; those below are out of reach now.
    EXPECT_EQ(after.two_body_tests, before.two_body_tests + 17);
    EXPECT_EQ(after.overlapping_count, before.overlapping_count - 9);
    EXPECT_EQ(after.cache_hits, before.cache_hits + after.overlapping_count - 17);
}

// The report's experiment with some ships at rest: the two-body test is called for exactly the candidate pairs
// of which a ship moved.
TEST(WorldWork, TheTwoBodyTestIsCalledForCandidatesThatMovedOnly) {
    scenes::RoomOptions options;
    options.ship_count = 64;
    options.frame_count = 20;
    options.moving_share = 0.25;
    const scenes::Scene scene = scenes::room(options);
    World world;
    std::vector<BodyId> bodies;
    for (const auto& body : scene.bodies) {
        bodies.push_back(world.create_body(scene.meshes[body.mesh_index].mesh, body.pose));
    }
    world.update();
    std::uint64_t cached = 0;
    for (const auto& frame : scene.frames) {
        std::vector<bool> moved(bodies.size() + 1);
        for (const auto& move : frame.moves) {
            world.set_pose(bodies[move.body_index], move.pose);
            moved[bodies[move.body_index].slot] = true;
        }
        const Statistics before = world.statistics();
        world.update();
        const Statistics after = world.statistics();
        std::uint64_t candidates_that_moved = 0;
        for (const BodyPair& pair : world.overlapping_pairs()) {
            candidates_that_moved += moved[pair.a.slot] || moved[pair.b.slot];
        }
        EXPECT_EQ(after.two_body_tests - before.two_body_tests, candidates_that_moved);
        EXPECT_EQ(after.cache_hits - before.cache_hits, after.overlapping_count - candidates_that_moved);
        EXPECT_EQ(after.queries.queries - before.queries.queries, candidates_that_moved);
        cached += after.cache_hits - before.cache_hits;
    }
    EXPECT_GT(cached, 0u);
}

}  // namespace
}  // namespace ecods
