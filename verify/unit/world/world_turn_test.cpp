// Which body is met first by one that turns, and which pairs meet while bodies turn, are translated, or go straight to
// new poses: known times, ties, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "ecods/builders.hpp"
#include "ecods/rounded.hpp"
#include "ecods/turn.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/own_meshes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_turn_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Turn half_turn{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};

std::shared_ptr<const Mesh> triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return Mesh::create({a, b, c}, {Triangle{0, 1, 2}});
}

// The point (5, 0, 0), which is at (3, 4, 0) at a third of half a turn, and a wall whose edge is there.
const auto point = triangle({5, 0, 0}, {5, 0, 0}, {5, 0, 0});
const auto wall = triangle({3, 4, -1}, {3, 4, 1}, {9, 12, 0});

class WorldTurnTest : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldTurnTest, broad_phases(), broad_phase_name);

TEST_P(WorldTurnTest, KnownTimesAndTies) {
    const BodyId a = world.create_body(point, Pose());
    EXPECT_EQ(world.cast(a, half_turn), std::nullopt);
    const BodyId b = world.create_body(wall, at(0)), c = world.create_body(wall, at(0));
    const auto first = world.cast(a, half_turn);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->body, b);
    EXPECT_EQ(first->contact.time, 1.0 / 3);
    EXPECT_EQ(first->contact.kind, ClosestKind::vertex_edge);
    EXPECT_EQ(world.cast(a, half_turn, infinity, memory), first);
    // The double nearest to a third is below it.
    EXPECT_EQ(world.cast(a, half_turn, 1.0 / 3), std::nullopt);
    EXPECT_EQ(world.cast(a, half_turn, std::nextafter(1.0 / 3, 1)), first);
    EXPECT_EQ(world.cast({point, Pose()}, half_turn)->body, a) << "which it touches at the start";
    EXPECT_EQ(world.cast({point, Pose()}, half_turn)->contact.time, 0);
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.cast(a, half_turn)->body, c);
    world.set_filter(c, {.groups = 2});
    EXPECT_EQ(world.cast({{point, Pose()}, CollisionFilter{.mask = 2}}, half_turn)->body, c);
    EXPECT_EQ(world.cast({{point, Pose()}, CollisionFilter{.mask = 4}}, half_turn), std::nullopt);
    const BodyId d = world.create_body(triangle({-3, 4, -1}, {-3, 4, 1}, {-9, 12, 0}), at(0));
    world.set_pair_enabled(a, c, false);
    EXPECT_EQ(world.cast(a, half_turn)->body, d);
    EXPECT_EQ(world.cast(a, Turn{{0, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()}), std::nullopt) << "the other way";
    EXPECT_EQ(world.cast(a, Turn{{0, 0, 0, 1}, Vec3::Zero(), {0, 0, 6}}), std::nullopt) << "above it by then";
}

// The feature of the body with the lesser id comes first, whichever of the two turns.
TEST_P(WorldTurnTest, FeaturesAreInTheOrderOfIds) {
    for (const bool turns_second : {true, false}) {
        const BodyId a = world.create_body(turns_second ? wall : point, Pose());
        const BodyId b = world.create_body(turns_second ? point : wall, Pose());
        const BodyId turning = turns_second ? b : a;
        const auto met = world.meetings(std::vector{turning}, std::vector<Motion>{half_turn});
        ASSERT_EQ(met.size(), 1u);
        EXPECT_EQ(met[0].bodies, std::min(BodyPair{a, b}, BodyPair{b, a}));
        const bool is_wall_first = (met[0].bodies.a == a) == turns_second;
        EXPECT_EQ(met[0].contact.a.kind, is_wall_first ? Feature::Kind::edge : Feature::Kind::vertex);
        EXPECT_EQ(met[0].contact.b.kind, is_wall_first ? Feature::Kind::vertex : Feature::Kind::edge);
        world.destroy_body(a);
        world.destroy_body(b);
    }
}

// The body of the greater id is met in the first piece of the turn, the other one by the rounded time of the same.
TEST_P(WorldTurnTest, TiesOfRoundedTimesAreFoundInAllPieces) {
    const BodyId a = world.create_body(point, Pose());
    const auto large = Mesh::create({{3, 4, -1}, {3, 4, 1}, {9, 12, 0}, {5, 0, 4}, {5, 1, 4}, {5, 1, 5}},
                                    {Triangle{0, 1, 2}, Triangle{3, 4, 5}});
    const BodyId b = world.create_body(wall, at(0)), c = world.create_body(large, at(0));
    EXPECT_EQ(world.cast(a, half_turn)->body, b);
    world.destroy_body(b);
    EXPECT_EQ(world.cast(a, half_turn)->body, c);
}

TEST_P(WorldTurnTest, SolidsAreMetInside) {
    const BodyId room = world.create_body(box({8, 8, 8}), at(0));
    const BodyId a = world.create_body(box({1, 1, 1}), at(1));
    const auto contact = world.cast(a, half_turn);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, room);
    EXPECT_EQ(contact->contact.kind, ClosestKind::contained);
    EXPECT_EQ(world.meetings(std::vector{a}, std::vector<Motion>{half_turn}).size(), 1u);
}

TEST_P(WorldTurnTest, BadArgumentsAreRefused) {
    const BodyId a = world.create_body(point, Pose()), b = world.create_body(wall, Pose());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, -infinity, nan}) EXPECT_INVALID(world.cast(a, half_turn, bad), Argument::time);
    EXPECT_INVALID(world.cast(a, Turn{{0, 0, 0, nan}, Vec3::Zero(), Vec3::Zero()}), Argument::turn);
    EXPECT_INVALID(world.cast(a, Turn{{-1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}), Argument::turn);
    EXPECT_THROW(std::ignore = world.cast(BodyId{}, half_turn), StaleBody);
    EXPECT_INVALID(world.cast({std::shared_ptr<const Mesh>(), Pose()}, half_turn), Argument::null);
    const std::vector bodies = {a, b};
    const auto refused = [&](const Motion& motion, Argument argument, const std::string& part) {
        try {
            std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn, motion});
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, argument);
            EXPECT_EQ(error.part, part);
            EXPECT_EQ(error.index, 1u);
            EXPECT_EQ(error.body, b);
        }
    };
    refused(Turn{{nan, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, Argument::turn, "q.w");
    refused(Turn{{1, 0, 0, 1}, Vec3::Zero(), {0, infinity, 0}}, Argument::turn, "pivot_to(1)");
    refused(Translation{{0, 0, nan}}, Argument::motion, "(2)");
    refused(Straight{at(infinity)}, Argument::pose, "t(0)");
    try {
        std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn});
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::list_length);
        EXPECT_EQ(error.part, "motions");
    }
    world.destroy_body(b);
    try {
        std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn, Translation()});
        ADD_FAILURE();
    } catch (const StaleBody& error) {
        EXPECT_EQ(error.index, 1u);
    }
}

TEST_P(WorldTurnTest, AnyTwoMotionsMayMeetAndTestsAreAsked) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(500)),
                 c = world.create_body(cube, at(900));
    const Translation up{{0, 0, 1}};
    const Straight there{at(0, 100)};
    const auto ask = [&](const Motion& first, const Motion& second) {
        return world.meetings(std::vector{a, b}, std::vector{first, second}).size();
    };
    EXPECT_EQ(ask(half_turn, half_turn), 0u);
    EXPECT_EQ(ask(half_turn, there), 0u);
    EXPECT_EQ(ask(there, up), 0u);
    EXPECT_EQ(ask(Straight{at(300)}, Translation{{-300, 0, 0}}), 1u);
    EXPECT_EQ(ask(Turn{{1, 0, 0, 1}, {500, 0, 0}, {500, 0, 0}}, Straight{at(500, -500)}), 1u) << "half-way";
    EXPECT_EQ(ask(half_turn, up), 0u);
    EXPECT_EQ(ask(up, up), 0u);
    EXPECT_EQ(ask(half_turn, Straight{at(500)}), 0u) << "which rests";
    EXPECT_EQ(ask(there, Translation()), 0u);
    // The later motion counts.
    const std::vector twice = {a, b, a};
    EXPECT_EQ(world.meetings(twice, std::vector<Motion>{half_turn, half_turn, up}).size(), 0u);
    const auto met = world.meetings(twice, std::vector<Motion>{half_turn, Translation{{400, 0, 0}}, up});
    ASSERT_EQ(met.size(), 1u);
    EXPECT_EQ(met[0].bodies, (BodyPair{b, c}));
    EXPECT_EQ(met[0].contact.time, 399.0 / 400);

    world.create_body(sphere(1), at(0, 700));
    const ShapeKind round = world.shape(world.bodies().back())->kind();
    expect_not_supported([&] { std::ignore = world.cast(a, half_turn); }, Question::cast_any_motion, ShapeKind::mesh(),
                         round);
    EXPECT_THROW(ask(half_turn, up), NotSupported);
    world.destroy_body(world.bodies().back());
    const auto own = std::make_shared<OwnShape>(cube);
    world.set_test(own_kind, own_kind, std::make_shared<OwnTest>(false));
    world.set_test(own_kind, ShapeKind::mesh(), std::make_shared<OwnTest>(false));
    const BodyId d = world.create_body(own, at(0, 700));
    const auto refuse = [&](const auto& call) {
        expect_not_supported(call, Question::cast_any_motion, own_kind, ShapeKind::mesh());
    };
    refuse([&] { std::ignore = world.cast(a, half_turn); });
    refuse([&] { std::ignore = world.cast(d, half_turn); });
    refuse([&] { ask(half_turn, up); });
    refuse([&] { ask(half_turn, there); });
    EXPECT_EQ(ask(there, Straight{at(600)}), 0u);
}

// A turn of which no bound in doubles holds is refused, wherever other bodies are.
TEST_P(WorldTurnTest, NearlyWholeTurnsAreRefused) {
    const BodyId a = world.create_body(cube, at(0));
    const Turn nearly{{-1, 0, 0, 0x1p-40}, Vec3::Zero(), Vec3::Zero()};
    EXPECT_EQ(world.cast(a, nearly), std::nullopt);
    world.create_body(cube, at(500));
    EXPECT_THROW(std::ignore = world.cast(a, nearly), NotSupported);
    EXPECT_THROW(std::ignore = world.meetings(std::vector{a}, std::vector<Motion>{nearly}), NotSupported);
}

// A long arm in a field of posts: only bodies near the way are asked, and none after the first that it meets.
TEST_P(WorldTurnTest, FarBodiesAreNotAsked) {
    const auto arm = box({8, 0.25, 0.25}), post = box({0.25, 0.25, 1});
    const BodyId a = world.create_body(arm, {.t = {4, 0, 0}});
    for (int x = -20; x <= 20; ++x) {
        for (int y = -20; y <= 20; ++y) {
            if (x * x + y * y > 100) world.create_body(post, {.t = {1.0 * x, 1.0 * y, 0}});
        }
    }
    QueryCounts counts;
    EXPECT_EQ(world.cast(a, half_turn, 1, {counts}), std::nullopt);
    EXPECT_LT(counts.queries, 100u);
    counts = {};
    const BodyId b = world.create_body(post, {.t = {6, 2, 0}});
    EXPECT_EQ(world.cast(a, half_turn, 1, {counts})->body, b);
    EXPECT_LT(counts.queries, 20u);
}

}  // namespace
}  // namespace ecods::world_turn_test
