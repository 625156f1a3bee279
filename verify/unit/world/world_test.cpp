#include "ecods/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_test {
namespace {

// What is true of a world does not depend on its broad phase.
class WorldTest : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldTest, broad_phases(), broad_phase_name);

TEST_P(WorldTest, AnEmptyWorldHasNothing) {
    world.update();
    EXPECT_TRUE(world.overlapping_pairs().empty());
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_TRUE(world.bodies().empty());
    world.check_invariants();
}

TEST_P(WorldTest, CubesThatShareAFaceTouch) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(1));
    world.update();
    const std::vector<BodyPair> expected{{a, b}};
    EXPECT_EQ(list(world.colliding_pairs()), expected);
    EXPECT_EQ(list(world.began()), expected);
    EXPECT_TRUE(world.ended().empty());
    EXPECT_EQ(world.relation(a, b), Relation::touching);
    EXPECT_EQ(world.relation(b, a), Relation::touching);
    world.check_invariants();
}

TEST_P(WorldTest, OneStepOfTheLastPlaceSeparates) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(std::nextafter(1.0, 2.0)));
    world.update();
    EXPECT_EQ(list(world.overlapping_pairs()), (std::vector<BodyPair>{{a, b}})) << "boxes are padded";
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_EQ(world.relation(a, b), Relation::apart);

    world.set_pose(b, at(std::nextafter(1.0, 0.0), 0.25, 0.25));
    world.update();
    EXPECT_EQ(world.relation(a, b), Relation::crossing);
    world.check_invariants();
}

TEST_P(WorldTest, ASurfaceInsideASurfaceDoesNotTouchIt) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(scenes::cube(0.25), at(0));
    world.update();
    EXPECT_EQ(world.overlapping_pairs().size(), 1u);
    EXPECT_FALSE(world.intersects(a, b));
}

TEST_P(WorldTest, EventsBeginAndEnd) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(5)),
                 c = world.create_body(cube, at(0.5, 0.5, 0.5));
    world.update();
    EXPECT_EQ(list(world.began()), (std::vector<BodyPair>{{a, c}}));

    world.update();
    EXPECT_TRUE(world.began().empty());
    EXPECT_TRUE(world.ended().empty());
    EXPECT_EQ(world.colliding_pairs().size(), 1u);

    world.set_pose(c, at(4.5, 0.5, 0.5));
    world.update();
    EXPECT_EQ(list(world.began()), (std::vector<BodyPair>{{b, c}}));
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{a, c}}));
    world.check_invariants();
}

TEST_P(WorldTest, ADestroyedBodysCollisionsEnd) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.5, 0.5, 0.5));
    world.update();
    world.destroy_body(a);
    EXPECT_FALSE(world.is_alive(a));
    EXPECT_EQ(world.colliding_pairs().size(), 1u) << "lists change at update";
    world.update();
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{a, b}}));
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_EQ(world.bodies(), std::vector<BodyId>{b});
    world.check_invariants();
}

TEST_P(WorldTest, ASlotThatIsUsedAgainIsAnotherBody) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.5, 0.5, 0.5));
    world.update();
    world.destroy_body(a);
    const BodyId c = world.create_body(cube, at(0));
    EXPECT_EQ(c.slot, a.slot);
    EXPECT_NE(c, a);
    world.update();
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{a, b}}));
    EXPECT_EQ(list(world.began()), (std::vector<BodyPair>{{c, b}}));
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{c, b}}));
    EXPECT_THROW(world.pose(a), StaleBody);
    world.check_invariants();
}

TEST_P(WorldTest, CreatedAndDestroyedBetweenUpdatesLeavesNoTrace) {
    const BodyId a = world.create_body(cube, at(0));
    world.update();
    world.destroy_body(world.create_body(cube, at(0.5)));
    world.update();
    EXPECT_TRUE(world.began().empty());
    EXPECT_TRUE(world.ended().empty());
    EXPECT_EQ(world.bodies(), std::vector<BodyId>{a});
    world.check_invariants();
}

TEST_P(WorldTest, SetShapeChangesTheAnswer) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(1.5));
    world.update();
    EXPECT_TRUE(world.colliding_pairs().empty());
    world.set_shape(b, scenes::cube(1));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{a, b}}));
    world.set_shape(b, cube);
    world.update();
    EXPECT_TRUE(world.colliding_pairs().empty());
    world.check_invariants();
}

TEST_P(WorldTest, TouchingTrianglesFollowTheOrderOfArguments) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(1, 1, 1));
    const auto ab = world.intersecting_triangles(a, b);
    auto ba = world.intersecting_triangles(b, a);
    ASSERT_FALSE(ab.empty());
    EXPECT_TRUE(std::ranges::is_sorted(ab));
    EXPECT_TRUE(std::ranges::is_sorted(ba));
    for (TrianglePair& pair : ba) std::swap(pair.a, pair.b);
    std::ranges::sort(ba);
    EXPECT_EQ(ab, ba);
}

TEST_P(WorldTest, DigestIsOfTheSceneNotOfItsHistory) {
    const BodyId a = world.create_body(cube, at(7)), b = world.create_body(cube, at(0.5));
    world.create_body(scenes::cube(2), at(0.25, 3));
    world.update();
    world.set_pose(a, at(0));
    world.update();

    World other{WorldOptions{GetParam()}};
    other.create_body(scenes::cube(2), at(0.25, 3));
    other.create_body(cube, at(0.5));
    other.create_body(cube, at(0));
    other.update();
    EXPECT_EQ(world.digest(), other.digest());

    world.set_pose(b, at(std::nextafter(0.5, 1)));
    world.update();
    EXPECT_NE(world.digest(), other.digest());
}

TEST_P(WorldTest, DigestIsOfEveryEntryOfAPose) {
    const BodyId a = world.create_body(cube, at(0));
    world.update();
    std::vector<std::uint64_t> digests = {world.digest()};
    for (int entry = 0; entry < 12; ++entry) {
        Pose pose;
        (entry < 9 ? pose.R(entry / 3, entry % 3) : pose.t[entry - 9]) = 0.5;
        world.set_pose(a, pose);
        world.update();
        digests.push_back(world.digest());
    }
    std::ranges::sort(digests);
    EXPECT_EQ(std::ranges::adjacent_find(digests), digests.end());
}

TEST_P(WorldTest, ManyTouchingCubesAreListedAscending) {
    constexpr int n = 4;
    for (int i = 0; i < n * n * n; ++i) world.create_body(cube, at(i % n, i / n % n, i / n / n));
    world.update();
    // Each cube touches those at most one step away on every axis.
    const int neighbours = (3 * n - 2) * (3 * n - 2) * (3 * n - 2) - n * n * n;
    EXPECT_EQ(world.colliding_pairs().size(), static_cast<std::size_t>(neighbours / 2));
    EXPECT_TRUE(std::ranges::is_sorted(world.colliding_pairs()));
    for (const BodyPair& pair : world.colliding_pairs()) {
        EXPECT_LT(pair.a, pair.b);
        EXPECT_EQ(world.relation(pair.a, pair.b), Relation::touching);
    }
    world.check_invariants();
}

TEST_P(WorldTest, HugeAndTinyBodiesLiveTogether) {
    Pose huge = at(0);
    huge.R *= 0x1p1000;
    Pose tiny = at(0);
    tiny.R *= 0x1p-1060;
    const BodyId a = world.create_body(cube, huge), b = world.create_body(cube, tiny);
    tiny.t = Vec3(0x1p999, 0, 0);
    const BodyId c = world.create_body(cube, tiny);
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{a, c}}));
    EXPECT_EQ(world.relation(a, c), Relation::crossing);
    EXPECT_FALSE(world.intersects(b, c));
    world.check_invariants();
}

}  // namespace
}  // namespace ecods::world_test
