// Arguments that are the world's own answers, in a program whose freed memory is overwritten.
#include <gtest/gtest.h>

#include "scenes/shapes.hpp"
#include "unit/world/watched_memory.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_memory_test {
namespace {

TEST(WatchedMemory, FailsTheAllocationThatWasAskedFor) {
    fail_allocation_after(1);
    void* const first = ::operator new(8);  // called by name: a compiler may leave out what a new-expression allocates
    EXPECT_THROW(::operator delete(::operator new(8)), std::bad_alloc);
    EXPECT_TRUE(allocation_has_failed());
    ::operator delete(first);
}

class WorldMemory : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldMemory, broad_phases(), broad_phase_name);

// The 2nd, 3rd, 5th, 9th body and so on make the world's lists grow while they are created.
TEST_P(WorldMemory, ABodyCanBeCreatedWhereAnotherIs) {
    Pose pose = at(3, 4, 5);
    pose.R(0, 1) = 0.25;
    std::vector<BodyId> bodies{world.create_body(cube, pose)};
    for (int i = 1; i < 40; ++i) {
        const BodyId model = bodies[static_cast<std::size_t>(i / 2)];
        bodies.push_back(world.create_body(world.shape(model), world.pose(model)));
        EXPECT_EQ(world.pose(bodies.back()), pose) << i;
        EXPECT_EQ(world.box(bodies.back()), world.box(model)) << i;
    }
    world.update();
    EXPECT_EQ(world.colliding_pairs().size(), 40u * 39 / 2);
    world.check_invariants();
}

TEST_P(WorldMemory, ABoxCanBeAddedToABroadPhaseWhereAnotherIs) {
    const auto phase = make_broad_phase(GetParam());
    const Aabb box{.min = Vec3(1, 2, 3), .max = Vec3(4, 5, 6)};
    phase->add(0, box);
    for (ProxyIndex proxy = 1; proxy < 40; ++proxy) {
        phase->add(proxy, phase->box(proxy / 2));
        EXPECT_EQ(phase->box(proxy), box) << proxy;
    }
    phase->update();
    phase->check_invariants();
    EXPECT_EQ(phase->pairs().size(), 40u * 39 / 2);
}

TEST_P(WorldMemory, AFilterAndAShapeCanBeAnotherBodys) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(scenes::cube(0.25), at(0.5));
    world.set_filter(a, {.groups = 6, .mask = 2});
    world.set_filter(b, world.filter(a));
    world.set_shape(b, world.shape(a));
    world.set_pose(b, world.pose(a));
    world.destroy_body(a);
    EXPECT_EQ(world.filter(b), (CollisionFilter{.groups = 6, .mask = 2}));
    EXPECT_EQ(world.pose(b), at(0));
    world.update();
    world.check_invariants();
}

}  // namespace
}  // namespace ecods::world_memory_test
