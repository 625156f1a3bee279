// What a body meets on the straight way from where a turn really ends to a pose of doubles.
#include <gtest/gtest.h>

#include <cmath>

#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "environment/each_environment.hpp"
#include "judge/way_questions.hpp"
#include "scenes/each_case.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/shapes.hpp"
#include "scenes/turn_cases.hpp"
#include "unit/query/turn_bodies.hpp"

namespace ecods {
namespace {

// q is no rotation of doubles: the tip ends at 5 (1 - c^2, 2 c, 0) / (1 + c^2) with c = 1 / 2^30 + 1 / 2.
const Quaternion some{1, 0, 0, 0.5 + 0x1p-30};

// A wall between the real end and a pose that is rounded: no double separates both from it, or it is beyond.
TEST(Settle, AWallInTheGap) {
    const MeshShape tip = shape_of({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
    const Turn turn = about_origin(some);
    const Pose end = pose_at(Pose(), turn, 1), to = {end.R, Vec3(0x1p-53, 0, 0)};
    const Vec3 place = end.R.col(0);
    const double end_x = place[0];  // the real end is half an ulp from it at most
    for (const double x :
         {std::nextafter(end_x, 0), std::nextafter(end_x, 1), std::nextafter(std::nextafter(end_x, 1), 1)}) {
        const MeshShape wall = shape_of({{x, -4, -4}, {x, 4, -4}, {x, 0, 8}});
        const bool is_beyond_end = x > end_x;
        const Turning<MeshShape> turning(tip, Pose(), turn);
        const auto wrong = judge::ask_about_settling(turning, {end.R, Vec3(0x1p-51, 0, 0)}, {wall, Pose()}, {});
        EXPECT_FALSE(wrong) << wrong->question << ": " << wrong->expected << ", not " << wrong->got;
        EXPECT_EQ(settle(turning, {end.R, Vec3(0x1p-51, 0, 0)}, {wall, Pose()}).has_value(), is_beyond_end) << x;
    }
    static_cast<void>(to);
}

TEST(Settle, KnownAnswers) {
    const MeshShape tip = shape_of(spike), wall = shape_of({{-4, 7, -9}, {4, 7, -9}, {0, 7, 18}});
    // A quarter of a turn: the tip ends at (0, 5, 0), and goes up to y = 9.
    const Turning<MeshShape> turning(tip, Pose(), about_origin({1, 0, 0, 1}));
    const Pose to{pose_at(Pose(), turning.turn, 1).R, Vec3(0, 4, 0)};
    const Contact contact = settle(turning, to, {wall, Pose()});
    expect_contact(contact, 0.5, ClosestKind::vertex_face);
    EXPECT_EQ(
        settle(Way<MeshShape>(tip, Pose(), {{{}, Vec3::Zero()}, {turning.turn.q, Vec3::Zero()}}), to, {wall, Pose()}),
        contact);
    EXPECT_FALSE(settle(turning, {to.R, Vec3(0, 1, 0)}, {wall, Pose()}));
    // At the end: a wall through the tip, and one that the body passes through.
    expect_contact(settle(turning, to, {wall, at({0, -2, 0})}), 0, ClosestKind::intersecting);
    expect_contact(settle(turning, to, {wall, at({0, -2.25, 0})}), 0, ClosestKind::intersecting);
    EXPECT_THROW(static_cast<void>(settle(turning, {to.R, Vec3(0, NAN, 0)}, {wall, Pose()})), InvalidArgument);
}

// Every family of turns, and then to poses near the end and far from it.
TEST(Settle, AsTheOracle) {
    scenes::Random random(9);
    QueryMemory memory;
    PairWitness witness;
    int met = 0, missed = 0;
    const auto count = [](std::string_view family) { return family == "gears" || family == "rods" ? 1 : 4; };
    scenes::for_each_case(scenes::turn_families(), 6, count, [&](const scenes::TurnCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > 400) return;
        const MeshShape a(made.a), b(made.b);
        const Turning<MeshShape> turning(a, made.pose_a, made.turn);
        Pose to = pose_at(made.pose_a, made.turn, 1);
        if (!to.R.allFinite() || !to.t.allFinite()) return;
        if (random.below(2) == 0) to.t += random.uniform(0, 1) * (made.pose_b.t - to.t);
        if (!to.t.allFinite()) return;
        const auto wrong = judge::ask_about_settling(turning, to, {b, made.pose_b}, {memory, witness});
        EXPECT_FALSE(wrong) << wrong->question << ": " << wrong->expected << ", not " << wrong->got;
        ++(settle(turning, to, {b, made.pose_b}, memory) ? met : missed);
    });
    EXPECT_GT(met, 5);
    EXPECT_GT(missed, 5);
}

TEST(Settle, TheSameBitsInEveryEnvironment) {
    const MeshShape ball(scenes::sphere(6, 4)), ring(scenes::torus(6, 4, 0.4));
    const Turning<MeshShape> turning(ball, at({4, 0, 0.25}), {some, Vec3::Zero(), Vec3(0, 0.5, 0)});
    const Pose end = pose_at(turning.pose, turning.turn, 1);
    const Posed<MeshShape> other(ring, at(end.t + Vec3(0, 3, 0)));
    const Pose to{end.R, end.t + Vec3(0, 3, 0)};
    const auto expected = settle(turning, to, other);
    EXPECT_TRUE(expected);
    environment::in_each_environment(
        [&] { return settle(turning, to, other); },
        [&](const auto& there, const std::string& where) { EXPECT_EQ(there, expected) << where; });
}

}  // namespace
}  // namespace ecods
