// First contacts on ways of several turns: known answers, what is refused, and families of cases beside the oracle.
#include "ecods/turn.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "environment/each_environment.hpp"
#include "judge/along_questions.hpp"
#include "judge/way_questions.hpp"
#include "scenes/each_case.hpp"
#include "scenes/shapes.hpp"
#include "scenes/turn_cases.hpp"
#include "unit/query/solid_soup.hpp"
#include "unit/query/turn_bodies.hpp"

namespace ecods {
namespace {

const Vec3 origin = Vec3::Zero();
const std::vector<WayNode> whole_turn_about_z{{{1, 0, 0, 0}, origin}, {{0, 0, 0, 1}, origin}, {{-1, 0, 0, 0}, origin}};

std::optional<WayContact> cast_along(const std::vector<Vec3>& a, const std::vector<WayNode>& nodes,
                                     const std::vector<Vec3>& b) {
    const MeshShape shape_a = shape_of(a), shape_b = shape_of(b);
    return cast(Way<MeshShape>(shape_a, Pose(), nodes), {shape_b, Pose()});
}

// The tip is at (3, 4, 0) at a third of the first half turn, and at (-3, -4, 0) at a third of the second.
TEST(Way, AWholeTurn) {
    const auto first = cast_along(spike, whole_turn_about_z, first_wall);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->leg, 0U);
    EXPECT_EQ(first->contact.time, 1 / 3.0);
    std::vector<Vec3> opposite = first_wall;
    for (Vec3& v : opposite) v = Vec3(-v[0], -v[1], v[2]);
    const auto second = cast_along(spike, whole_turn_about_z, opposite);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->leg, 1U);
    EXPECT_EQ(second->contact.time, 1 / 3.0);
    EXPECT_EQ(second->contact.kind, first->contact.kind);
    const std::vector<Vec3> away{{0, 0, 3}, {1, 0, 4}, {0, 1, 4}};
    EXPECT_FALSE(cast_along(spike, whole_turn_about_z, away));
}

// A contact at a node is the last one of the leg before it; one at the start is at time 0 of leg 0.
TEST(Way, ContactAtANode) {
    const std::vector<Vec3> tip{{5, 0, 0}, {5, 0, 0}, {5, 0, 0}}, target{{-5, 0, 0}, {-5, 0, 0}, {-5, 0, 0}};
    const auto at_node = cast_along(tip, whole_turn_about_z, target);
    ASSERT_TRUE(at_node);
    EXPECT_EQ(at_node->leg, 0U);
    EXPECT_EQ(at_node->contact.time, 1);
    EXPECT_EQ(at_node->contact.kind, ClosestKind::vertex_vertex);
    const auto at_start = cast_along(tip, whole_turn_about_z, tip);
    ASSERT_TRUE(at_start);
    EXPECT_EQ(at_start->leg, 0U);
    EXPECT_EQ(at_start->contact.time, 0);
    EXPECT_EQ(at_start->contact.kind, ClosestKind::intersecting);
}

// From one axis to another: a quarter about z, then about y through the world. Quaternions are those since the start.
TEST(Way, AboutTwoAxes) {
    const Quaternion quarter{1, 0, 0, 1}, then{1, 1, 1, 1};  // (x, y, z) to (-y, x, z), then to (z, x, y)
    const std::vector<WayNode> nodes{{{}, origin}, {quarter, origin}, {then, Vec3(0, 0, 7)}};
    const std::vector<Vec3> tip{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}, target{{0, 1, 7}, {0, 1, 7}, {0, 1, 7}};
    const auto met = cast_along(tip, nodes, target);
    ASSERT_TRUE(met);
    EXPECT_EQ(met->leg, 1U);
    EXPECT_EQ(met->contact.time, 1);
    EXPECT_EQ(pose_at(Pose(), nodes, 1, 1).t, Vec3(0, 0, 7));
    EXPECT_EQ(Vec3(pose_at(Pose(), nodes, 1, 1).R * Vec3(1, 2, 3)), Vec3(3, 1, 2));
    EXPECT_EQ(pose_at(Pose(), nodes, 0, 1), pose_at(Pose(), nodes, 1, 0));
    EXPECT_EQ(pose_at(Pose(), nodes, 0, 0.25), pose_at(Pose(), Turn{quarter, origin, origin}, 0.25));
}

// A later leg turns about where the pivot is then.
TEST(Way, AfterAGlide) {
    const Vec3 up(0, 0, 7);
    const std::vector<WayNode> nodes{{{2, 0, 0, 0}, origin}, {{1, 0, 0, 0}, up}, {{0, 0, 0, 1}, up}};
    std::vector<Vec3> wall = first_wall;
    for (Vec3& v : wall) v += up;
    const auto met = cast_along(spike, nodes, wall);
    ASSERT_TRUE(met);
    EXPECT_EQ(met->leg, 1U);
    EXPECT_EQ(met->contact.time, 1 / 3.0);
    EXPECT_EQ(met->contact.kind, ClosestKind::vertex_face);
}

// Bodies of any size are turned alike.
TEST(Way, Scales) {
    for (const int exponent : {-900, -300, 0, 300, 900}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto vector = [&](double x, double y, double z) { return Vec3(unit * Vec3(x, y, z)); };
        const Vec3 pivot = vector(1, 2, 3);
        const std::vector<WayNode> nodes{{{}, pivot}, {{0, 0, 0, -1}, pivot}, {{}, pivot}, {{0, 0, 0, 1}, pivot}};
        const auto met = cast_along({vector(6, 2, 3), vector(6, 1, 3), vector(6, 1, 4)}, nodes,
                                    {vector(4, 6, 2), vector(4, 6, 4), vector(5, 9, 3)});
        ASSERT_TRUE(met) << exponent;
        EXPECT_EQ(met->leg, 2U) << exponent;
        EXPECT_EQ(met->contact.time, 1 / 3.0) << exponent;
        EXPECT_EQ(met->contact.kind, ClosestKind::vertex_edge) << exponent;
    }
}

TEST(Way, Refusals) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](std::vector<WayNode> nodes, const std::string& part, ListIndex index) {
        try {
            static_cast<void>(cast_along(spike, nodes, first_wall));
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::turn);
            EXPECT_EQ(error.part, part);
            EXPECT_EQ(error.index, index);
        }
    };
    refused({}, "nodes", {});
    refused({{{}, origin}}, "nodes", {});
    refused({{{}, origin}, {{1, 0, nan, 0}, origin}}, "q.y", 1);
    refused({{{}, origin}, {{}, Vec3(0, INFINITY, 0)}}, "pivot(1)", 1);
    refused({{{}, origin}, {{0, 0, 0, 0}, origin}}, "q", 1);
    refused({{{1, 1, 0, 0}, origin}, {{}, origin}}, "q", 0);
    refused({{{-1, 0, 0, 0}, origin}, {{}, origin}}, "q", 0);
    refused({{{}, origin}, {{-2, 0, 0, 0}, origin}}, "q", 1);
    refused({{{}, origin}, {{1, 2, 3, 4}, origin}, {{-0.5, -1, -1.5, -2}, origin}}, "q", 2);
    EXPECT_THROW(static_cast<void>(pose_at(Pose(), whole_turn_about_z, 2, 0)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(pose_at(Pose(), whole_turn_about_z, 0, 1.5)), InvalidArgument);
    EXPECT_THROW(Way<MeshShape>(std::shared_ptr<MeshShape>(), Pose(), whole_turn_about_z), InvalidArgument);
    // One bit beside a negative multiple: nearly a whole turn.
    const std::vector<WayNode> nearly{
        {{}, origin}, {{1, 2, 3, 4}, origin}, {{-1, -2, -3, std::nextafter(-4, 0)}, origin}};
    EXPECT_THROW(static_cast<void>(cast_along(spike, nearly, {{0, 0, 9}, {1, 0, 9}, {0, 1, 9}})), NotSupported);
}

// Solids meet at time 0 if one is inside the other; names are those of their meshes.
TEST(Way, OfSolids) {
    const Solid cube(box({-1, -1, -1}, {1, 1, 1})), small(box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}));
    const auto inside = cast(Way<MeshShape>(small, Pose(), whole_turn_about_z), {cube, Pose()});
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->contact.kind, ClosestKind::contained);
    const auto kept = std::make_shared<const Solid>(cube.mesh_ptr());
    const Way way(kept, Pose{Mat3::Identity(), Vec3(4, 0, 0)}, whole_turn_about_z);
    EXPECT_TRUE(cast(Way<MeshShape>(kept, way.pose, way.nodes), {cube, Pose{Mat3::Identity(), Vec3(-3, -3, 0)}}));
}

Quaternion any_quaternion(scenes::Random& random) {
    const auto number = [&] { return static_cast<double>(random.below(7)) - 3; };
    return {number(), number(), number(), 0.5 + static_cast<double>(random.below(3))};
}

// Every family of turns, as a way of two nodes and through another node and back, with the points of contacts.
TEST(Way, AsTheOracle) {
    scenes::Random random(5);
    QueryMemory memory;
    PairWitness witness;
    int judged = 0;
    const auto count = [](std::string_view family) {
        return family == "rods" || family == "doors" || family == "gears" || family == "bodies of distances" ? 1 : 3;
    };
    scenes::for_each_case(scenes::turn_families(), 3, count, [&](const scenes::TurnCase& made) {
        const MeshShape a(made.a), b(made.b);
        const WayNode between{any_quaternion(random), made.turn.pivot_to};
        try {
            const auto wrong =
                judge::ask_about_turn_as_way({a, made.pose_a, made.turn}, between, {b, made.pose_b}, {memory, witness});
            EXPECT_FALSE(wrong) << wrong->question << ": " << wrong->expected << ", not " << wrong->got;
            ++judged;
        } catch (const NotSupported&) {
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.part, "q");  // `between` is opposite to a node
        }
    });
    EXPECT_GT(judged, 25);
}

// Casts along nodes, in equal shares of the time, in both orders and at limits of time: two, three and four legs, with
// pivots that glide.
TEST(Way, InSharesOfTheTimeAsTheOracle) {
    scenes::Random random(7);
    QueryMemory memory;
    PairWitness witness;
    int judged = 0, after_first_leg = 0;
    const auto count = [](std::string_view family) { return family == "rods" || family == "gears" ? 1 : 3; };
    scenes::for_each_case(scenes::turn_families(), 5, count, [&](const scenes::TurnCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > 64) return;
        const MeshShape a(made.a), b(made.b);
        Way<MeshShape> way(a, made.pose_a, {{{}, made.turn.pivot_from}});
        for (auto legs = 1 + random.below(3); legs > 0; --legs) {
            way.nodes.push_back(
                {any_quaternion(random), random.below(2) == 0 ? made.turn.pivot_to : way.nodes[0].pivot});
        }
        way.nodes.push_back({made.turn.q, made.turn.pivot_to});
        try {
            const auto wrong = judge::ask_about_along(way, {b, made.pose_b}, {memory, witness});
            EXPECT_FALSE(wrong) << wrong->question << ": " << wrong->expected << ", not " << wrong->got;
            const auto met = cast(way, {b, made.pose_b});
            after_first_leg += met && met->leg > 0;
            ++judged;
        } catch (const NotSupported&) {
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.part, "q");  // opposite to the node before
        }
    });
    EXPECT_GT(judged, 20);
    EXPECT_GT(after_first_leg, 1);
}

// The search sees the same in every environment.
TEST(Way, TheSameBitsInEveryEnvironment) {
    const MeshShape ball(scenes::sphere(6, 4)), ring(scenes::torus(6, 4, 0.4));
    const std::vector<WayNode> nodes{
        {{}, origin}, {{0.5, 0.25, 0, 1}, origin}, {{-0.25, 0.5, 1, 0.75}, Vec3(0, 0.5, 0)}};
    const Way<MeshShape> way(ball, {Mat3::Identity(), Vec3(4, 0, 0.25)}, nodes);
    const Posed<MeshShape> other(ring, pose_at(way.pose, nodes, 1, 0.75));
    const auto ask = [&] { return std::pair(cast(way, other), cast({ball, way.pose}, Along{nodes}, other, Motion())); };
    const auto expected = ask();
    EXPECT_TRUE(expected.first);
    EXPECT_TRUE(expected.second);
    environment::in_each_environment(
        ask, [&](const auto& there, const std::string& where) { EXPECT_EQ(there, expected) << where; });
}

}  // namespace
}  // namespace ecods
