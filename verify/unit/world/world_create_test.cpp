// Bodies made with options, and questions in a memory of the caller's.
#include <gtest/gtest.h>

#include <sstream>

#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_create_test {
namespace {

const std::shared_ptr<const Mesh> cube = scenes::cube(0.5);

TEST(WorldCreate, TakesEveryOption) {
    World world;
    const auto shape = std::make_shared<const MeshShape>(cube);
    const BodyOptions options{.shape = shape, .pose = at(3), .filter = {.groups = 4, .mask = 6}, .user_data = 99};
    const BodyId a = world.create_body(options);
    EXPECT_EQ(world.shape(a), shape);
    EXPECT_EQ(world.pose(a), at(3));
    EXPECT_EQ(world.filter(a), options.filter);
    EXPECT_EQ(world.user_data(a), 99u);
    const BodyId b = world.create_body({.mesh = cube});
    EXPECT_EQ(world.pose(b), Pose());
    EXPECT_EQ(world.filter(b), CollisionFilter());
    EXPECT_EQ(world.user_data(b), 0u);
}

TEST(WorldCreate, RefusesNoneAndBothOfMeshAndShape) {
    World world;
    EXPECT_INVALID(world.create_body(BodyOptions{}), Argument::null);
    EXPECT_INVALID(world.create_body({.mesh = cube, .shape = std::make_shared<MeshShape>(cube)}),
                   Argument::mesh_and_shape);
    EXPECT_TRUE(world.bodies().empty());
}

// A filter that comes with the body counts at once: the pair never collides.
TEST(WorldCreate, AFilterHoldsFromTheStart) {
    World world;
    world.create_body({.mesh = cube, .filter = {.mask = 0}});
    world.create_body({.mesh = cube});
    world.update();
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_EQ(world.statistics().filtered_count, 1u);
    world.check_invariants();
}

TEST(WorldCreate, OptionsAreTraced) {
    World world;
    std::stringstream trace;
    world.trace_to(trace);
    world.create_body({.mesh = cube, .filter = {.groups = 2, .mask = 1}, .user_data = 7});
    world.create_body({.mesh = cube, .filter = {.groups = 1, .mask = 3}});
    world.update();
    const ReplayReport report = replay(trace, {.checks_invariants = true});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.colliding_count, 1u);
    EXPECT_EQ(report.update_count, 1u);
}

TEST(WorldCreate, AConstWorldAnswersInAMemoryOfTheCallers) {
    World world;
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(1));
    const World& asked = world;
    QueryMemory memory;
    EXPECT_TRUE(asked.intersects(a, b, memory));
    EXPECT_EQ(asked.relation(b, a, memory), Relation::touching);
    EXPECT_EQ(asked.intersecting_triangles(a, b, memory), world.intersecting_triangles(a, b));
    EXPECT_EQ(asked.intersecting_bodies({cube, at(0.25)}, memory), (std::vector{a, b}));
    EXPECT_EQ(asked.intersecting_bodies({scenes::cube(0.25), at(-0.5)}, memory), (std::vector{a}));
    EXPECT_EQ(asked.intersecting_bodies({MeshShape(cube), at(2)}, memory), (std::vector{b}));
    const CollisionFilter meets_none{.groups = 1, .mask = 0};
    EXPECT_EQ(asked.intersecting_bodies({{cube, at(0.25)}, meets_none}, memory), std::vector<BodyId>());
    EXPECT_INVALID(asked.intersecting_bodies({std::shared_ptr<const Mesh>(), at(0)}, memory), Argument::null);
    EXPECT_GE(memory.counts().queries, 7u);
}

}  // namespace
}  // namespace ecods::world_create_test
