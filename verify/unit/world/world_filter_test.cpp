// Which pairs are tested at all.

#include <gtest/gtest.h>

#include <algorithm>

#include "ecods/world.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_filter_test {
namespace {

TEST(CollisionFilter, EachMustNameAGroupOfTheOther) {
    EXPECT_TRUE(may_meet({}, {}));
    EXPECT_TRUE(may_meet({.groups = 2, .mask = 4}, {.groups = 4, .mask = 2}));
    EXPECT_FALSE(may_meet({.groups = 2, .mask = 4}, {.groups = 4, .mask = 1}));
    EXPECT_FALSE(may_meet({.groups = 2, .mask = 1}, {.groups = 4, .mask = 2}));
    EXPECT_FALSE(may_meet({.groups = 0}, {}));
    EXPECT_FALSE(may_meet({}, {.mask = 0}));
    constexpr std::uint64_t last = std::uint64_t{1} << 63;
    EXPECT_TRUE(may_meet({.groups = last, .mask = last}, {.groups = last, .mask = last}));
}

// Three cubes that all collide.
class WorldFilterTest : public EachWorld {
  protected:
    WorldFilterTest() { world.update(); }
    ~WorldFilterTest() override { world.check_invariants(); }

    using Pairs = std::vector<BodyPair>;
    std::uint64_t tests() const { return world.statistics().two_body_tests; }

    BodyId a = world.create_body(cube, at(0));
    BodyId b = world.create_body(cube, at(0.5, 0.5, 0.5));
    BodyId c = world.create_body(cube, at(0.25, 0.25, 0.25));
    const BodyPair ab{a, b}, ac{a, c}, bc{b, c};
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldFilterTest, broad_phases(), broad_phase_name);

TEST_P(WorldFilterTest, AFilterActsAtTheNextUpdateWithEvents) {
    EXPECT_EQ(world.filter(a), CollisionFilter());
    world.set_filter(a, {.groups = 2, .mask = 2});
    EXPECT_EQ(world.filter(a).groups, 2u);
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ab, ac, bc}));
    EXPECT_EQ(list(world.overlapping_pairs()), (Pairs{ab, ac, bc}));
    const std::uint64_t before = tests();
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{bc}));
    EXPECT_EQ(list(world.overlapping_pairs()), (Pairs{bc}));
    EXPECT_EQ(list(world.ended()), (Pairs{ab, ac}));
    EXPECT_TRUE(world.began().empty());
    EXPECT_EQ(tests(), before) << "a pair that is filtered out is not tested, and the others are as they were";
    EXPECT_EQ(world.statistics().overlapping_count, 1u);
    EXPECT_EQ(world.statistics().filtered_count, 2u);
    EXPECT_TRUE(world.intersects(a, b)) << "questions about a pair are about geometry";
    world.check_invariants();

    // The group of a is met by b, which a's mask names.
    world.set_filter(b, {.groups = 3, .mask = 3});
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{ab}));
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ab, bc}));
    EXPECT_EQ(tests(), before + 1) << "the verdict of b and c was kept";
}

TEST_P(WorldFilterTest, SettingTheFilterThatIsThereOrThereAndBackIsNoEvent) {
    const std::uint64_t before = tests();
    world.set_filter(a, {});
    world.set_filter(b, {.mask = 0});
    world.set_filter(b, {});
    world.update();
    EXPECT_TRUE(world.began().empty());
    EXPECT_TRUE(world.ended().empty());
    EXPECT_EQ(tests(), before);
}

TEST_P(WorldFilterTest, APairIsSwitchedOffAndOn) {
    world.set_pair_enabled(b, a, false);
    EXPECT_FALSE(world.is_pair_enabled(a, b));
    EXPECT_TRUE(world.is_pair_enabled(a, c));
    EXPECT_EQ(world.colliding_pairs().size(), 3u);
    const std::uint64_t before = tests();
    world.update();
    EXPECT_EQ(list(world.ended()), (Pairs{ab}));
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ac, bc}));
    EXPECT_EQ(list(world.overlapping_pairs()), (Pairs{ac, bc}));
    world.set_pair_enabled(a, b, false);
    world.update();
    EXPECT_TRUE(world.ended().empty());

    // It stays off while its bodies move.
    world.set_pose(a, at(0.125));
    world.update();
    EXPECT_EQ(tests(), before + 1);
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ac, bc}));
    world.check_invariants();

    world.set_pair_enabled(a, b, true);
    EXPECT_TRUE(world.is_pair_enabled(b, a));
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{ab}));
    EXPECT_EQ(tests(), before + 2);
    EXPECT_EQ(list(world.overlapping_pairs()), (Pairs{ab, ac, bc}));
}

TEST_P(WorldFilterTest, OnePairOfABodyIsSwitchedOnWhileAnotherStaysOff) {
    for (const auto& [on, off] : {std::pair(ac, bc), {bc, ac}, {ab, bc}, {ac, ab}}) {
        world.set_pair_enabled(on.a, on.b, false);
        world.set_pair_enabled(off.a, off.b, false);
        world.set_pair_enabled(on.b, on.a, true);
        EXPECT_TRUE(world.is_pair_enabled(on.a, on.b));
        EXPECT_FALSE(world.is_pair_enabled(off.a, off.b));
        EXPECT_FALSE(world.is_pair_enabled(off.b, off.a));
        world.update();
        EXPECT_EQ(list(world.overlapping_pairs()).size(), 2u);
        EXPECT_EQ(std::ranges::count(world.colliding_pairs(), off), 0);
        world.set_pair_enabled(off.a, off.b, true);
        world.update();
        EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ab, ac, bc}));
    }
}

TEST_P(WorldFilterTest, OffAndOnBetweenUpdatesIsNoEventAndOneTestAtMost) {
    const std::uint64_t before = tests();
    world.set_pair_enabled(a, b, false);
    world.set_pair_enabled(a, b, true);
    world.set_pair_enabled(a, b, false);
    world.set_pair_enabled(a, b, true);
    world.update();
    EXPECT_TRUE(world.began().empty());
    EXPECT_TRUE(world.ended().empty());
    EXPECT_EQ(tests(), before);
    world.set_pair_enabled(a, b, false);
    world.update();
    world.set_pair_enabled(a, b, true);
    world.set_pose(a, at(-0.125));
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{ab}));
    EXPECT_EQ(tests(), before + 2);

    world.set_pair_enabled(a, b, false);
    world.update();
    for (const bool is_enabled : {true, false, true}) world.set_pair_enabled(a, b, is_enabled);
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{ab})) << "once, however often it was switched";
    EXPECT_EQ(tests(), before + 3);
}

TEST_P(WorldFilterTest, ThePairNeedsBothTheFilterAndTheSwitch) {
    world.set_filter(a, {.mask = 0});
    world.set_pair_enabled(a, b, false);
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{bc}));
    world.set_pair_enabled(a, b, true);
    world.update();
    EXPECT_TRUE(world.began().empty());
    world.set_filter(a, {});
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{ab, ac}));
}

TEST_P(WorldFilterTest, TheSwitchOutlivesTheOverlap) {
    world.set_pair_enabled(a, b, false);
    world.set_pose(b, at(50));
    world.update();
    world.set_pose(b, at(0.5, 0.5, 0.5));
    world.update();
    EXPECT_EQ(list(world.colliding_pairs()), (Pairs{ac, bc}));
}

TEST_P(WorldFilterTest, WhatIsSwitchedOffDiesWithTheBody) {
    world.set_pair_enabled(a, b, false);
    world.set_pair_enabled(a, c, false);
    world.set_filter(a, {.mask = 0});
    world.set_user_data(a, 7);
    world.destroy_body(a);
    const BodyId d = world.create_body(cube, at(0));
    ASSERT_EQ(d.slot, a.slot);
    EXPECT_TRUE(world.is_pair_enabled(d, b));
    EXPECT_EQ(world.filter(d), CollisionFilter());
    EXPECT_EQ(world.user_data(d), 0u);
    world.update();
    EXPECT_EQ(list(world.began()), (Pairs{{d, b}, {d, c}}));
    EXPECT_THROW(world.is_pair_enabled(a, b), StaleBody);
    EXPECT_THROW(world.set_pair_enabled(b, a, true), StaleBody);
    EXPECT_THROW(world.set_pair_enabled(b, b, false), SameBody);
    EXPECT_THROW(world.set_filter(a, {}), StaleBody);
    EXPECT_THROW(world.filter(a), StaleBody);
}

TEST_P(WorldFilterTest, ADestroyedBodysPairThatWasOffEndsSilently) {
    world.set_pair_enabled(a, b, false);
    world.update();
    world.destroy_body(b);
    world.update();
    EXPECT_EQ(list(world.ended()), (Pairs{bc}));
    EXPECT_EQ(world.statistics().filtered_count, 0u);
}

TEST_P(WorldFilterTest, DigestsAreOfTheCollisionsThatAreLeft) {
    const std::uint64_t all = world.digest();
    world.set_pair_enabled(a, b, false);
    world.update();
    const std::uint64_t off = world.digest();
    EXPECT_NE(off, all);
    world.set_pair_enabled(a, b, true);
    world.update();
    EXPECT_EQ(world.digest(), all);
}

}  // namespace
}  // namespace ecods::world_filter_test
