// Which body an id names, and when it names none.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "ecods/trace.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_id_test {
namespace {

const std::shared_ptr<const Mesh> cube = scenes::cube(0.5);

// Each call of a world that takes an id, one after the other; the world must be none of this id.
void expect_stale(World& world, BodyId stale, BodyId own) {
    QueryMemory memory;
    EXPECT_FALSE(world.is_alive(stale));
    EXPECT_THROW(world.pose(stale), StaleBody);
    EXPECT_THROW(world.shape(stale), StaleBody);
    EXPECT_THROW(world.box(stale), StaleBody);
    EXPECT_THROW(world.filter(stale), StaleBody);
    EXPECT_THROW(world.user_data(stale), StaleBody);
    EXPECT_THROW(world.set_pose(stale, at(1)), StaleBody);
    EXPECT_THROW(world.set_poses(std::vector{own, stale}, std::vector{at(1), at(2)}), StaleBody);
    EXPECT_THROW(world.set_shape(stale, cube), StaleBody);
    EXPECT_THROW(world.set_filter(stale, {}), StaleBody);
    EXPECT_THROW(world.set_user_data(stale, 1), StaleBody);
    EXPECT_THROW(world.set_pair_enabled(own, stale, false), StaleBody);
    EXPECT_THROW(world.is_pair_enabled(stale, own), StaleBody);
    EXPECT_THROW(static_cast<void>(world.intersects(own, stale)), StaleBody);
    EXPECT_THROW(static_cast<void>(world.relation(stale, own, memory)), StaleBody);
    EXPECT_THROW(static_cast<void>(world.intersecting_triangles(stale, own)), StaleBody);
    EXPECT_THROW(world.destroy_body(stale), StaleBody);
    EXPECT_EQ(world.pose(own), at(0));
}

TEST(WorldId, OfAnotherWorldIsRecognised) {
    World first, second;
    const BodyId a = first.create_body(cube, at(0)), b = second.create_body(cube, at(0));
    EXPECT_NE(a, b);
    EXPECT_EQ(numbers_of(a), numbers_of(b));
    expect_stale(first, b, a);
    expect_stale(second, a, b);
    // The number goes where the world goes.
    World moved = std::move(first);
    EXPECT_TRUE(moved.is_alive(a));
    expect_stale(moved, b, a);
}

TEST(WorldId, WrittenWithoutItsWorldIsOfTheWorldThatItIsGivenTo) {
    World first, second;
    const BodyId a = first.create_body(cube, at(0)), b = second.create_body(cube, at(7));
    const BodyId written{a.slot, a.generation};
    EXPECT_EQ(first.pose(written), at(0));
    EXPECT_EQ(second.pose(written), at(7));
    second.destroy_body(written);
    EXPECT_FALSE(second.is_alive(b));
}

TEST(WorldId, EqualsAnotherOnlyOfItsWorldAndIsOrderedBySlotFirst) {
    EXPECT_NE((BodyId{1, 2, 3}), (BodyId{1, 2, 4}));
    EXPECT_LT((BodyId{1, 2, 9}), (BodyId{1, 3, 1}));
    EXPECT_LT((BodyId{1, 9, 9}), (BodyId{2, 0, 0}));
    EXPECT_LT((BodyId{0xffff'fffe, 9, 9}), (BodyId{0xffff'ffff, 0, 0}));
    EXPECT_EQ(sizeof(BodyId), 8u);
}

// The number of a world is in no text and in no digest: two worlds that do the same write the same.
TEST(WorldId, ReachesNoTrace) {
    std::string texts[2];
    for (std::string& text : texts) {
        World world;
        std::ostringstream out;
        world.trace_to(out);
        const BodyId a = world.create_body({.mesh = cube, .pose = at(0), .filter = {.groups = 2}, .user_data = 5});
        world.create_body(cube, at(0.5));
        world.update();
        world.destroy_body(a);
        world.update();
        world.end_trace();
        text = out.str();
        try {
            world.destroy_body(a);
        } catch (const StaleBody& error) {
            text += error.what();
        }
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_NE(texts[0].find("body 1.0 is not alive"), std::string::npos) << texts[0];
}

// 65,536 bodies in one slot use its generations up; it is left alone from then on, so that no id comes twice.
TEST(WorldId, NeverNamesABodyOfLater) {
    World world;
    const BodyId first = world.create_body(cube, at(0));
    world.destroy_body(first);
    std::set<BodyId> ids{first};
    for (int i = 0; i < 65'540; ++i) {
        const BodyId id = world.create_body(cube, at(0));
        ASSERT_TRUE(ids.insert(id).second) << i;
        ASSERT_FALSE(world.is_alive(first));
        world.destroy_body(id);
    }
    EXPECT_EQ(ids.rbegin()->slot, 2u);
    EXPECT_EQ(world.statistics().body_count, 0u);
    world.update();
    world.check_invariants();
    const BodyId last = world.create_body(cube, at(0));
    EXPECT_EQ(last.slot, 2u);
    world.update();
    EXPECT_EQ(world.statistics().body_count, 1u);
    EXPECT_EQ(world.bodies(), std::vector<BodyId>{last});
    world.check_invariants();
}

// Bodies that were and that are, of some slots of which one is used up.
World used_world() {
    World world;
    std::vector<BodyId> made;
    for (int i = 0; i < 6; ++i) made.push_back(world.create_body(cube, at(i)));
    for (const int i : {4, 1, 3}) world.destroy_body(made[static_cast<std::size_t>(i)]);
    while (world.next_ids().front().slot == 4) world.destroy_body(world.create_body(cube, at(0)));
    world.create_body(cube, at(9));
    world.set_pair_enabled(made[5], made[0], false);
    return world;
}

std::vector<BodyId> all_ids(const World& world) {
    std::vector<BodyId> ids = world.bodies();
    for (const BodyId id : world.next_ids()) ids.push_back(id);
    return ids;
}

TEST(WorldId, IsTheSameInACopyOfAWorld) {
    World first = used_world();
    World copy({.ids = all_ids(first)});
    for (const BodyId id : first.bodies()) EXPECT_EQ(copy.create_body(first.shape(id), first.pose(id)), id);
    EXPECT_EQ(copy.bodies(), first.bodies());
    EXPECT_EQ(copy.next_ids(), first.next_ids());
    EXPECT_EQ(first.disabled_pairs().size(), 1u);
    for (const auto& [a, b] : first.disabled_pairs()) copy.set_pair_enabled(a, b, false);
    EXPECT_EQ(copy.disabled_pairs(), first.disabled_pairs());
    // A stale id is stale in the copy, and no new body gets it.
    const BodyId stale{2, 0, copy.bodies().front().world};
    for (World* const world : {&first, &copy}) {
        EXPECT_FALSE(world->is_alive(stale));
        world->update();
        world->check_invariants();
    }
    EXPECT_EQ(copy.digest(), first.digest());
    for (int i = 0; i < 4; ++i) {
        const BodyId next = first.next_ids().front();
        EXPECT_EQ(first.create_body(cube, at(20 + i)), next);
        EXPECT_EQ(copy.create_body(cube, at(20 + i)), next);
        EXPECT_NE(next.slot, 4u) << "its generations are used up";
    }
    // Others have ids of their own.
    EXPECT_NE(World().create_body(cube, at(0)).world, stale.world);
}

// The calls of a history are the digits of its number, of base 4: a body comes, which does not meet the one before it,
// or the first, second or third one that lives goes.
constexpr int call_kinds = 4, histories_of_six_calls = 4096;

void play_history(World& world, int history) {
    std::set<BodyId> given;
    for (int rest = history; rest != 0; rest /= call_kinds) {
        const std::vector<BodyId> bodies = world.bodies();
        if (const auto going = static_cast<std::size_t>(rest % call_kinds); going != 0) {
            if (going <= bodies.size()) world.destroy_body(bodies[going - 1]);
            continue;
        }
        const BodyId coming = world.next_ids().front(), body = world.create_body(cube, at(0));
        ASSERT_EQ(body, coming);
        ASSERT_TRUE(given.insert(body).second) << "an id comes twice";
        if (!bodies.empty()) world.set_pair_enabled(body, bodies.back(), false);
    }
}

// The slots are at the end of their generations (1), one before it (2), used up (3) and new (4).
TEST(WorldId, IsTheSameInACopyAfterEveryHistoryOfSixCalls) {
    const std::vector<BodyId> at_the_end = {{2, 65'534, 7}, {1, 65'535, 7}, {4, 0, 7}};
    for (int history = 0; history < histories_of_six_calls; ++history) {
        SCOPED_TRACE(history);
        World world({.ids = at_the_end});
        play_history(world, history);
        const std::vector<BodyId> bodies = world.bodies();
        World copy({.ids = all_ids(world)});
        for (const BodyId body : bodies) ASSERT_EQ(copy.create_body(cube, at(0)), body);
        for (const auto& [a, b] : world.disabled_pairs()) copy.set_pair_enabled(a, b, false);
        for (World* const each : {&world, &copy}) {
            if (!bodies.empty()) each->destroy_body(bodies.front());
            each->update();
            each->check_invariants();
        }
        for (int i = 0; i < 5; ++i) {
            ASSERT_EQ(copy.next_ids(), world.next_ids());
            ASSERT_EQ(copy.disabled_pairs(), world.disabled_pairs());
            ASSERT_EQ(copy.create_body(cube, at(0)), world.create_body(cube, at(0)));
        }
        ASSERT_EQ(copy.bodies(), world.bodies());
        ASSERT_FALSE(copy.is_alive({3, 65'535, 7})) << "its generations are used up";
    }
}

// Ids of which none is of a new slot, the highest slot first or last.
TEST(WorldId, OfTheFirstBodiesAreThoseThatAreGiven) {
    const BodyId one{1, 3, 7}, two{2, 5, 7}, then{3, 0, 7};
    for (const auto& ids : {std::vector{one, two}, std::vector{two, one}}) {
        World world({.ids = ids});
        EXPECT_EQ(world.next_ids(), (std::vector{ids[0], ids[1], then}));
        for (const BodyId id : {ids[0], ids[1], then}) EXPECT_EQ(world.create_body(cube, at(0)), id);
    }
}

TEST(WorldId, GivenFirstIsRefusedUnlessEachSlotComesOnceAndOfOneWorld) {
    const auto index_of_refused = [](std::vector<BodyId> ids) {
        try {
            World world({.ids = std::move(ids)});
        } catch (const StaleBody& error) {
            return static_cast<int>(error.index.value());
        }
        return -1;
    };
    EXPECT_EQ(index_of_refused({}), -1);
    EXPECT_EQ(index_of_refused({{3, 1, 7}, {1, 0, 7}}), -1);
    EXPECT_EQ(index_of_refused({{3, 1, 7}, {}}), 1);
    EXPECT_EQ(index_of_refused({{3, 1, 7}, {1, 0, 7}, {3, 2, 7}}), 2);
    EXPECT_EQ(index_of_refused({{3, 1, 7}, {1, 0, 8}}), 1);
    World of_written({.ids = {{2, 5}, {1, 0}}});
    of_written.update();
    of_written.check_invariants();
    EXPECT_NE(of_written.create_body(cube, at(0)).world, 0u) << "written without a world: of a new one";
}

TEST(WorldId, NoneIsAliveInAWorldThatWasMovedFrom) {
    World world;
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(1));
    World other = std::move(world);
    QueryMemory memory;
    std::ostringstream out;
    EXPECT_FALSE(world.is_alive(a));
    EXPECT_THROW(world.create_body(cube, at(0)), MovedFromWorld);
    EXPECT_THROW(world.destroy_body(a), MovedFromWorld);
    EXPECT_THROW(world.set_pose(a, at(0)), MovedFromWorld);
    EXPECT_THROW(world.set_poses({}, {}), MovedFromWorld);
    EXPECT_THROW(world.set_shape(a, cube), MovedFromWorld);
    EXPECT_THROW(world.pose(a), MovedFromWorld);
    EXPECT_THROW(world.shape(a), MovedFromWorld);
    EXPECT_THROW(world.box(a), MovedFromWorld);
    EXPECT_THROW(world.user_data(a), MovedFromWorld);
    EXPECT_THROW(world.set_user_data(a, 1), MovedFromWorld);
    EXPECT_THROW(world.bodies(), MovedFromWorld);
    EXPECT_THROW(world.next_ids(), MovedFromWorld);
    EXPECT_THROW(world.disabled_pairs(), MovedFromWorld);
    EXPECT_THROW(world.reserve(1), MovedFromWorld);
    EXPECT_THROW(world.set_filter(a, {}), MovedFromWorld);
    EXPECT_THROW(world.filter(a), MovedFromWorld);
    EXPECT_THROW(world.set_pair_enabled(a, b, false), MovedFromWorld);
    EXPECT_THROW(world.is_pair_enabled(a, b), MovedFromWorld);
    EXPECT_THROW(world.set_test(ShapeKind(), ShapeKind(), nullptr), MovedFromWorld);
    EXPECT_THROW(world.update(), MovedFromWorld);
    EXPECT_THROW(world.overlapping_pairs(), MovedFromWorld);
    EXPECT_THROW(world.colliding_pairs(), MovedFromWorld);
    EXPECT_THROW(world.began(), MovedFromWorld);
    EXPECT_THROW(world.ended(), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.intersects(a, b)), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.relation(a, b, memory)), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.intersecting_triangles(a, b)), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.overlapping_bodies(other.box(a))), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.intersecting_bodies({cube, at(0)})), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.all_hits(std::vector<Segment>())), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.all_hits(std::vector<Ray>())), MovedFromWorld);
    EXPECT_THROW(static_cast<void>(world.meetings({}, std::span<const Pose>())), MovedFromWorld);
    EXPECT_THROW(world.trace_to(out), MovedFromWorld);
    EXPECT_THROW(world.end_trace(), MovedFromWorld);
    EXPECT_THROW(world.statistics(), MovedFromWorld);
    EXPECT_THROW(world.check_invariants(), MovedFromWorld);
    EXPECT_THROW(world.digest(), MovedFromWorld);
    world = std::move(other);
    EXPECT_EQ(world.pose(a), at(0));
}

}  // namespace
}  // namespace ecods::world_id_test
