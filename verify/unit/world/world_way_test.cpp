// Which body is met first by one that goes along a way, and at which time: known times, ties, and what is refused.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "ecods/turn.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/own_meshes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_way_test {
namespace {

const Vec3 origin = Vec3::Zero();
const Quaternion half_about_z{0, 0, 0, 1};
const Along whole_turn{{{{}, origin}, {half_about_z, origin}, {{-1, 0, 0, 0}, origin}}};
const Turn half_turn{half_about_z, origin, origin};

std::shared_ptr<const Mesh> triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return Mesh::create({a, b, c}, {Triangle{0, 1, 2}});
}

// The point (5, 0, 0), which is at (3, 4, 0) at a third of half a turn, and a wall whose edge is there; and a wall at
// (3, -4, 0), which it reaches at two thirds of the other half.
const auto point = triangle({5, 0, 0}, {5, 0, 0}, {5, 0, 0});
const auto wall = triangle({3, 4, -1}, {3, 4, 1}, {9, 12, 0});
constexpr double late_time = (1 + 2.0 / 3) / 2;
const auto late_wall = triangle({3, -4, -1}, {3, -4, 1}, {9, -12, 0});

class WorldWayTest : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldWayTest, broad_phases(), broad_phase_name);

TEST_P(WorldWayTest, KnownTimesAndTies) {
    const BodyId a = world.create_body(point, Pose());
    EXPECT_EQ(world.cast(a, whole_turn), std::nullopt);
    const BodyId late = world.create_body(late_wall, at(0));
    auto first = world.cast(a, whole_turn);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->body, late);
    EXPECT_EQ(first->contact.time, late_time);
    EXPECT_EQ(first->contact.kind, ClosestKind::vertex_edge);
    EXPECT_EQ(world.cast(a, half_turn), std::nullopt) << "the first leg alone";
    const BodyId b = world.create_body(wall, at(0)), c = world.create_body(wall, at(0));
    first = world.cast(a, whole_turn);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->body, b) << "of two that tie, the least id";
    EXPECT_EQ(first->contact.time, 1.0 / 6);
    EXPECT_EQ(world.cast(a, whole_turn, 1.0 / 6), first) << "a time counts up to itself";
    EXPECT_EQ(world.cast(a, whole_turn, std::nextafter(1.0 / 6, 0)), std::nullopt);
    EXPECT_EQ(world.cast(a, whole_turn, std::numeric_limits<double>::infinity(), memory), first);
    EXPECT_EQ(world.cast({point, Pose()}, whole_turn)->body, a) << "which it touches at the start";
    EXPECT_EQ(world.cast({point, Pose()}, whole_turn)->contact.time, 0);
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.cast(a, whole_turn)->body, c);
    world.set_pair_enabled(a, c, false);
    world.set_pair_enabled(b, c, false);
    EXPECT_EQ(world.cast(a, whole_turn)->body, late);
    EXPECT_EQ(world.cast(a, whole_turn, 0.5), std::nullopt);
    EXPECT_EQ(world.cast(a, whole_turn, late_time)->body, late);
    const auto met = world.meetings(std::vector{a}, std::vector<Motion>{whole_turn});
    ASSERT_EQ(met.size(), 1u);
    EXPECT_EQ(met[0].bodies, (BodyPair{a, late}));
    EXPECT_EQ(met[0].contact.time, late_time);
    EXPECT_EQ(world.meetings(std::vector{late, a}, std::vector<Motion>{Translation(), whole_turn}), met);
}

bool is_nearest(double x, const mpq_class& number) {
    const auto off = [&](double y) { return mpq_class(abs(mpq_class(y) - number)); };
    return off(x) <= off(std::nextafter(x, 2)) && off(x) <= off(std::nextafter(x, -1));
}

// Of n legs one turns, and the others rest. One leg is a Turn, whose real time counts.
TEST(WorldWay, TimesOfAllLegsAreRoundedOnce) {
    World world;
    const BodyId a = world.create_body(point, Pose());
    world.create_body(wall, at(0));
    int others = 0;
    for (int n = 2; n <= 24; ++n) {
        for (int k = 0; k < n; ++k) {
            Along along;
            for (int i = 0; i <= n; ++i) along.nodes.push_back({i <= k ? Quaternion() : half_about_z, origin});
            const auto met = world.cast(a, along);
            ASSERT_TRUE(met);
            const double time = met->contact.time, in_leg = 1.0 / 3;
            EXPECT_TRUE(is_nearest(time, (k + mpq_class(in_leg)) / n)) << k << " of " << n;
            others += time != (k + in_leg) / n;
            EXPECT_EQ(world.cast(a, along, time), met);
            EXPECT_EQ(world.cast(a, along, std::nextafter(time, 0)), std::nullopt);
        }
    }
    EXPECT_GT(others, 0) << "so a quotient that is rounded twice would be noticed";
}

TEST_P(WorldWayTest, ContactsAtNodes) {
    const BodyId a = world.create_body(point, Pose());
    const auto opposite = triangle({-5, 0, 0}, {-5, 0, 0}, {-5, 0, 0});
    const BodyId b = world.create_body(opposite, at(0));
    EXPECT_EQ(world.cast(a, whole_turn)->contact.time, 0.5);
    EXPECT_EQ(world.cast(a, whole_turn, 0.5)->body, b);
    EXPECT_EQ(world.cast(a, whole_turn, std::nextafter(0.5, 0)), std::nullopt);
    // A time in a leg of 2^-1000 is a positive time, too.
    const Along down{{{{}, origin}, {{}, {0, 0, -1}}, {{}, {0, 0, -1}}, {{}, {0, 0, -1}}}};
    world.create_body(point, {.t = {0, 0, 0x1p-1000}});
    world.destroy_body(a);
    EXPECT_EQ(world.cast({point, Pose{.t = {0, 0, 0x1p-999}}}, down)->contact.time, 0x1p-1000 / 3);
    // On a later leg it is lost beside the time at which the leg begins, which is then the contact's, too.
    const Along later{{{{}, origin}, {{}, origin}, {{}, {0, 0, -1}}}};
    EXPECT_EQ(world.cast({point, Pose{.t = {0, 0, 0x1p-999}}}, later, 0.5)->contact.time, 0.5);
    EXPECT_EQ(world.cast({point, Pose{.t = {0, 0, 0x1p-999}}}, later, std::nextafter(0.5, 0)), std::nullopt);
}

// The feature of the body with the lesser id comes first, whichever of the two moves.
TEST_P(WorldWayTest, FeaturesAreInTheOrderOfIds) {
    for (const bool moves_second : {true, false}) {
        const BodyId a = world.create_body(moves_second ? wall : point, Pose());
        const BodyId b = world.create_body(moves_second ? point : wall, Pose());
        const BodyId moved = moves_second ? b : a;
        const auto met = world.meetings(std::vector{moved}, std::vector<Motion>{whole_turn});
        ASSERT_EQ(met.size(), 1u);
        const bool is_wall_first = (met[0].bodies.a == a) == moves_second;
        EXPECT_EQ(met[0].contact.a.kind, is_wall_first ? Feature::Kind::edge : Feature::Kind::vertex);
        EXPECT_EQ(met[0].contact.b.kind, is_wall_first ? Feature::Kind::vertex : Feature::Kind::edge);
        world.destroy_body(a);
        world.destroy_body(b);
    }
}

TEST_P(WorldWayTest, SolidsAreMetInside) {
    const BodyId room = world.create_body(box({8, 8, 8}), at(0));
    const BodyId a = world.create_body(box({1, 1, 1}), at(1));
    const auto contact = world.cast(a, whole_turn);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, room);
    EXPECT_EQ(contact->contact.time, 0);
    EXPECT_EQ(contact->contact.kind, ClosestKind::contained);
}

TEST_P(WorldWayTest, BadNodesAreRefused) {
    const BodyId a = world.create_body(point, Pose()), b = world.create_body(wall, Pose());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, nan}) EXPECT_INVALID(world.cast(a, whole_turn, bad), Argument::time);
    const auto refused = [&](const Along& along, const std::string& part, const ListIndex& index) {
        try {
            std::ignore = world.cast(a, along);
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::turn);
            EXPECT_EQ(error.part, part);
            EXPECT_EQ(error.index, index);
        }
        try {
            std::ignore = world.meetings(std::vector{b, a}, std::vector<Motion>{Translation(), along});
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::turn);
            EXPECT_EQ(error.part, part);
            EXPECT_EQ(error.body, a);
            EXPECT_EQ(error.index, 1u);
        }
    };
    refused({}, "nodes", {});
    refused({{{{}, origin}}}, "nodes", {});
    refused({{{half_about_z, origin}, {{}, origin}}}, "q", 0);
    refused({{{{}, origin}, {{-1, 0, 0, 0}, origin}}}, "q", 1);
    refused({{{{}, origin}, {{1, nan, 0, 0}, origin}}}, "q.x", 1);
    refused({{{{}, origin}, {{}, origin}, {{}, {0, nan, 0}}}}, "pivot(1)", 2);
}

// Beside a body that moves, a way is refused by name; two nodes from the quaternion 1 on are a turn.
TEST_P(WorldWayTest, WaysBesideOtherMotionsAreRefused) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(500));
    const auto ask = [&](const Motion& first, const Motion& second) {
        return world.meetings(std::vector{a, b}, std::vector{first, second}).size();
    };
    const auto refused = [&](const Motion& first, const Motion& second) {
        try {
            ask(first, second);
            ADD_FAILURE();
        } catch (const NotSupported& error) {
            EXPECT_NE(std::string(error.what()).find("a body goes along a way, and another one moves"),
                      std::string::npos);
        }
    };
    refused(whole_turn, whole_turn);
    refused(whole_turn, half_turn);
    refused(Translation{{0, 0, 1}}, whole_turn);
    refused(whole_turn, Straight{at(501)});
    EXPECT_EQ(ask(whole_turn, Translation()), 0u);
    EXPECT_EQ(ask(Straight{at(0)}, whole_turn), 0u) << "which rests";
    const Along turn{{{{}, origin}, {half_about_z, origin}}};
    EXPECT_EQ(ask(turn, half_turn), 0u);
    EXPECT_EQ(ask(turn, Translation{{0, 0, 1}}), 0u);
    refused(Along{{{{2, 0, 0, 0}, origin}, {half_about_z, origin}}}, half_turn);
    // The later motion counts.
    const std::vector twice = {a, b, a};
    EXPECT_EQ(world.meetings(twice, std::vector<Motion>{whole_turn, half_turn, half_turn}).size(), 0u);
    const auto own = std::make_shared<OwnShape>(cube);
    world.set_test(own_kind, own_kind, std::make_shared<OwnTest>(false));
    world.set_test(own_kind, ShapeKind::mesh(), std::make_shared<OwnTest>(false));
    const BodyId d = world.create_body(own, at(0, 700));
    const auto refuse = [&](const auto& call) {
        expect_not_supported(call, Question::cast_any_motion, own_kind, ShapeKind::mesh());
    };
    refuse([&] { std::ignore = world.cast(a, whole_turn); });
    refuse([&] { std::ignore = world.cast(d, whole_turn); });
}

// A long arm in a field of posts: only bodies near the legs are asked, and none of legs after the first contact.
TEST_P(WorldWayTest, FarBodiesAreNotAsked) {
    const auto arm = box({8, 0.25, 0.25}), post = box({0.25, 0.25, 1});
    const BodyId a = world.create_body(arm, {.t = {4, 0, 0}});
    for (int x = -20; x <= 60; ++x) {
        for (int y = -20; y <= 20; ++y) {
            if (y * y > 100) world.create_body(post, {.t = {1.0 * x, 1.0 * y, 0}});
        }
    }
    const Along there{{{{}, origin}, {{}, {40, 0, 0}}, {half_about_z, {40, 0, 0}}}};
    QueryCounts counts;
    EXPECT_EQ(world.cast(a, there, 1, {counts}), std::nullopt);
    EXPECT_LT(counts.queries, 300u);
    counts = {};
    const BodyId b = world.create_body(post, {.t = {12, 0, 0}});
    EXPECT_EQ(world.cast(a, there, 1, {counts})->body, b);
    EXPECT_LT(counts.queries, 10u);
    const BodyId ahead = world.create_body(post, {.t = {40, 7, 0}});
    const Along into_the_field{{{{}, origin}, {{}, {20, 0, 0}}, {{}, {20, 30, 0}}}};
    counts = {};
    EXPECT_EQ(world.cast(a, into_the_field, 1, {counts})->body, b);
    EXPECT_LT(counts.queries, 10u) << "none of the second leg";
    // The far end of the arm meets a post behind the pivot, and one that is near the second leg alone.
    world.destroy_body(b);
    const BodyId behind = world.create_body(post, {.t = {-7, 0, 0}});
    const Along around{{{{}, origin}, {half_about_z, origin}, {{}, origin}}};
    EXPECT_EQ(world.cast(a, around)->body, behind);
    EXPECT_EQ(world.meetings(std::vector{a}, std::vector<Motion>{around}).size(), 1u);
    EXPECT_EQ(world.cast(a, there)->body, ahead);
    EXPECT_EQ(world.meetings(std::vector{a}, std::vector<Motion>{there}).size(), 1u);
    world.create_body(post, {.t = {30, 0, 0}});
    const Along rests_first{{{{}, origin}, {{}, origin}, {{}, {40, 0, 0}}}};
    EXPECT_EQ(world.meetings(std::vector{a}, std::vector<Motion>{rests_first}).size(), 1u) << "beyond the first leg";
}

}  // namespace
}  // namespace ecods::world_way_test
