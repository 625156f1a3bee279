// Straight motions and turns of rounded bodies that are translations: known times, and random bodies against the
// oracle; half spaces that are met on the way; and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/turn.hpp"
#include "ecods/world.hpp"
#include "environment/each_environment.hpp"
#include "oracle/half_space.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/half_space_cases.hpp"
#include "unit/query/near_times.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods::rounded_moves_test {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;
using scenes::Random;
using Fraction = mpq_class;
using Point = oracle::Vector<Fraction>;

Moving<Rounded> moving(const Ball& body, const Pose& from, const Pose& to) {
    return {body, from, to};
}
Mat3 quarter() {
    return (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
}

// Expects one contact in both orders, and as a limit of the time.
std::optional<FirstContact> cast_both(const Moving<Rounded>& a, const Moving<Rounded>& b) {
    const auto found = cast(a, b), back = cast(b, a);
    EXPECT_EQ(found.has_value(), back.has_value());
    if (!found || !back) return std::nullopt;
    EXPECT_EQ(found->time, back->time);
    EXPECT_EQ(found->kind, back->kind);
    EXPECT_TRUE(found->time <= 0 || !cast(a, b, std::nextafter(found->time, 0)));
    const auto by = cast(a, b, found->time);
    EXPECT_TRUE(!by || *by == *found);
    return found;
}

TEST(RoundedMoves, KnownTimes) {
    const Ball three = sphere(3), two = sphere(2), far = sphere(1, {100, 0, 0});
    const Pose start;
    EXPECT_EQ(cast_both(moving(three, start, at(10)), moving(two, at(15), at(15)))->time, 1);
    EXPECT_EQ(cast_both(moving(three, start, at(10)), moving(two, at(20), at(10)))->time, 0.75);
    EXPECT_EQ(cast_both(moving(three, start, at(10)), moving(two, at(std::nextafter(15.0, 16)), at(16))), std::nullopt);
    EXPECT_EQ(cast_both(moving(three, start, at(2)), moving(two, at(8), at(10))), std::nullopt) << "they move alike";
    EXPECT_EQ(cast_both(moving(three, start, at(2)), moving(two, at(5), at(7)))->time, 0);
    // The matrix takes the ball's center from (100, 0, 0) to (0, 100, 0), straight: (50, 50, 0) halfway.
    const Pose turned{quarter(), Vec3::Zero()};
    const auto grazed = cast_both(moving(far, start, turned), moving(three, at(48, 48), at(48, 48)));
    ASSERT_TRUE(grazed.has_value());
    EXPECT_LT(grazed->time, 0.5);
    EXPECT_EQ(cast_both(moving(far, start, turned), moving(three, at(0, 0), at(0, 0))), std::nullopt);
    // Differences of poses that are no doubles: the real gap closes at 1, or just not.
    const double tiny = 0x1p-60;
    EXPECT_TRUE(cast_both(moving(sphere(1), at(-1), at(tiny)), moving(sphere(1), at(2 + 0x1p-51), at(2))).has_value());
    EXPECT_FALSE(
        cast_both(moving(sphere(1), at(-1), at(-tiny)), moving(sphere(1), at(2 + 0x1p-51), at(2))).has_value());
}

// The centers as the oracle has them: their difference goes straight, so they are two points, one translated.
TEST(RoundedMoves, BallsByAnyMatricesAsTheOracle) {
    Random random(3);
    int met = 0;
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const auto any_pose = [&] {
            Pose pose = random.turned();
            pose.R.col(1) *= random.uniform(-2, 2);
            pose.t = 4 * random.direction();
            return pose;
        };
        const double p = random.uniform(0.1, 2), q = i % 4 == 0 ? 0x1p-300 : random.uniform(0.1, 1);
        const Vec3 center = random.direction();
        const Ball a = sphere(p, center), b = sphere(q, Vec3(-center));
        const Pose from_a = any_pose(), to_a = any_pose(), from_b = any_pose(), to_b = any_pose();
        const auto found = cast_both(moving(a, from_a, to_a), moving(b, from_b, to_b));
        if (intersects(Posed<Rounded>(a, from_a), Posed<Rounded>(b, from_b))) {
            EXPECT_EQ(found->time, 0);
            continue;
        }
        const auto place = [](const Ball& body, const Pose& pose) {
            return oracle::exact_posed(body->core().mesh().vertices()[0], pose);
        };
        const auto a0 = place(a, from_a), a1 = place(a, to_a), b0 = place(b, from_b), b1 = place(b, to_b);
        Point start, step;
        for (std::size_t k = 0; k < 3; ++k) {
            start[k] = a0[k] - b0[k];
            step[k] = (a1[k] - b1[k]) - start[k];
        }
        const Point zero{};
        const auto truth =
            oracle::RoundedMotion({start, start, start}, {zero, zero, zero}, step, Fraction(p) + Fraction(q)).first(1);
        ASSERT_EQ(found.has_value(), truth.has_value());
        if (truth) {
            EXPECT_EQ(found->time, *truth);
        }
        met += truth.has_value();
    }
    EXPECT_GT(met, 20);
}

// A straight motion to a translated pose is the translation by the difference, where that is a vector of doubles.
TEST(RoundedMoves, TranslatedBodiesAsByTranslations) {
    Random random(5);
    for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const auto lattice = [&] {
            return Vec3(random.below(17) - 8.0, random.below(17) - 8.0, random.below(17) - 8.0);
        };
        const Ball a = around(scenes::cube(1), 0.25 * random.below(4));
        const Ball b = i % 2 == 0 ? capsule(Vec3::Zero(), lattice(), 0.5) : around(scenes::torus(5, 4, 0.3), 0.125);
        Pose from_a = random.turned(), from_b = random.turned();
        from_a.t = lattice();
        from_b.t = lattice();
        const Vec3 way_a = lattice(), way_b = lattice();
        const Pose to_a{from_a.R, from_a.t + way_a}, to_b{from_b.R, from_b.t + way_b};
        const auto expected = cast(Posed<Rounded>(a, from_a), Vec3(way_a - way_b), Posed<Rounded>(b, from_b));
        EXPECT_EQ(cast_both(moving(a, from_a, to_a), moving(b, from_b, to_b)), expected);
        const Posed<Rounded> x(a, from_a), y(b, from_b);
        EXPECT_EQ(cast(x, Motion(Translation{way_a}), y, Motion(Straight{to_b})), expected);
        const Turn glide{{}, Vec3(9, 9, 9), Vec3(9, 9, 9) + way_a};
        EXPECT_EQ(cast(x, Motion(glide), y, Motion(Translation{way_b})), expected);
        const Posed<MeshShape> core(b->core_ptr(), from_b);
        const auto of_mesh = cast(x, Vec3(way_a - way_b), core);
        EXPECT_EQ(cast(moving(a, from_a, to_a), Moving<MeshShape>(b->core_ptr(), from_b, to_b)), of_mesh);
        EXPECT_EQ(cast(x, Motion(Translation{way_a}), core, Motion(Translation{way_b})), of_mesh);
        const auto back = cast(core, Motion(Translation{way_b}), x, Motion(Translation{way_a}));
        EXPECT_EQ(back ? back->time : -1, of_mesh ? of_mesh->time : -1);
    }
}

TEST(RoundedMoves, WhatIsNoTranslationIsRefused) {
    const Ball ball = sphere(1), bone = capsule({0, 0, 0}, {0, 0, 1}, 0.5), thin = capsule({0, 0, 0}, {0, 0, 1}, 0);
    const Pose start, there = at(9), turned{quarter(), Vec3(3, 0, 0)};
    const auto refused = [](const auto& ask, Question question, ShapeKind a, ShapeKind b) {
        try {
            std::ignore = ask();
            ADD_FAILURE();
        } catch (const NotSupported& error) {
            EXPECT_EQ(error.question, question);
            EXPECT_EQ(error.a, a);
            EXPECT_EQ(error.b, b);
        }
    };
    const ShapeKind round = ball->kind(), mesh = ShapeKind::mesh();
    const auto cube = std::make_shared<const MeshShape>(scenes::cube(1));
    refused([&] { return cast(moving(bone, start, turned), moving(ball, there, there)); }, Question::cast_moving, round,
            round);
    refused([&] { return cast(Moving<MeshShape>(cube, start, turned), moving(ball, there, there)); },
            Question::cast_moving, mesh, round);
    for (int k = 0; k < 3; ++k) {  // a matrix that changes in one column
        Pose other = start;
        other.R(k, k) = 2;
        refused([&] { return cast(moving(bone, start, other), moving(ball, there, there)); }, Question::cast_moving,
                round, round);
    }
    EXPECT_TRUE(cast(moving(ball, start, turned), Moving<MeshShape>(cube, at(4), at(4))).has_value());
    // Without radii, the cores may move in any way.
    EXPECT_EQ(
        cast(moving(thin, start, turned), moving(thin, at(1), at(1))),
        cast(Moving<MeshShape>(thin->core_ptr(), start, turned), Moving<MeshShape>(thin->core_ptr(), at(1), at(1))));
    // A ball that turns about its own center is translated; about another axis it is not.
    const Turn spin{{1, 0, 0, 1}, Vec3(2, 0, 0), Vec3(8, 0, 0)}, orbit{{1, 0, 0, 1}, Vec3(2, 1, 0), Vec3(8, 1, 0)};
    const Posed<Rounded> wheel(ball, at(2)), other(ball, at(8));
    EXPECT_EQ(cast(wheel, Motion(spin), other, Motion())->time, 4.0 / 6);
    EXPECT_EQ(cast(wheel, Motion(Turn{{0, 0, 0, 1}, Vec3(2, 0, 7), Vec3(8, 0, 7)}), other, Motion())->time, 4.0 / 6);
    refused([&] { return cast(wheel, Motion(orbit), other, Motion()); }, Question::cast_any_motion, round, round);
    // Two nodes are a turn; more of them are no translation, not even if the center goes straight.
    Along along{{{{1, 0, 0, 0}, spin.pivot_from}, {spin.q, spin.pivot_to}}};
    EXPECT_EQ(cast(wheel, Motion(along), other, Motion()), cast(wheel, Motion(spin), other, Motion()));
    along.nodes.push_back(along.nodes.back());
    refused([&] { return cast(wheel, Motion(along), other, Motion()); }, Question::cast_any_motion, round, round);
    EXPECT_THROW(std::ignore = cast(wheel, Motion(spin), other, Motion(), -1), InvalidArgument);
    EXPECT_THROW(std::ignore = cast(wheel, Motion(Turn{{0, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}), other, Motion()),
                 InvalidArgument);
    EXPECT_THROW(std::ignore = cast(moving(ball, start, there), moving(ball, there, there), std::nan("")),
                 InvalidArgument);
}

// ---- half spaces

// The first time at which a vertex is at the height of r |N|, over all vertices.
std::optional<double> true_time(const half_space_cases::Case& c, const Pose& end, const Vec3& plane_end,
                                double radius) {
    const oracle::ExactHeights start({c.half_space->normal(), c.half_space->offset(), c.at});
    const oracle::ExactHeights last({c.half_space->normal(), c.half_space->offset(), {c.at.R, plane_end}});
    const auto& G = start.direction();
    const Fraction square = G[0] * G[0] + G[1] * G[1] + G[2] * G[2];
    const Fraction r(radius);
    std::optional<oracle::FractionAndRoot> first;
    std::optional<double> least;
    for (const Triangle& triangle : c.shape->mesh().triangles()) {
        for (const std::uint32_t vertex : triangle) {
            const Vec3& v = c.shape->mesh().vertices()[vertex];
            const Fraction h0 = start.at(v, c.body), h1 = last.at(v, end);
            if (oracle::FractionAndRoot{h1, -r, square}.sign() > 0) continue;
            const Fraction fall = h0 - h1;
            const double time = oracle::nearest({h0 / fall, -r / fall, square});
            if (!least || time < *least) least = time;
        }
    }
    return least;
}

TEST(RoundedMoves, HalfSpacesAsTheOracle) {
    Random random(8);
    int met = 0;
    for (int i = 0; i < 600 && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        using namespace half_space_cases;
        const Case c = i % 3 == 0 ? lattice(random) : i % 3 == 1 ? general(random) : scaled(random, general(random));
        const double signed_one = signed_distance({c.shape, c.body}, {c.half_space, c.at}).distance;
        const double radii[] = {0x1p-60, random.uniform(0, 3), std::abs(signed_one) / 2, std::abs(signed_one)};
        const double radius = std::isfinite(signed_one) ? radii[random.below(4)] : 1;
        const Ball body = std::make_shared<const Rounded>(c.shape, radius);
        const Moving<HalfSpace> plane(c.half_space, c.at, {c.at.R, c.half_space_end});
        const auto found = cast(moving(body, c.body, c.end), plane);
        if (intersects({body, c.body}, {c.half_space, c.at})) {
            ASSERT_TRUE(found.has_value());
            EXPECT_EQ(found->time, 0);
            EXPECT_EQ(*found, *cast(Posed<Rounded>(body, c.body), Vec3::Zero(), Posed<HalfSpace>(c.half_space, c.at)));
            continue;
        }
        const auto truth = true_time(c, c.end, c.half_space_end, radius);
        ASSERT_EQ(found.has_value(), truth.has_value());
        if (!truth) continue;
        ++met;
        EXPECT_EQ(found->time, std::max(*truth, 0x1p-1074));
        EXPECT_EQ(found->kind, ClosestKind::vertex_face);
        EXPECT_TRUE(found->time <= 0 || !cast(moving(body, c.body, c.end), plane, std::nextafter(found->time, 0)));
    }
    EXPECT_GT(met, 40);
}

// Of a body that turns beside a half space, which may not.
TEST(RoundedMoves, HalfSpacesThatTurnAreRefused) {
    const HalfSpace ground(Vec3::UnitZ(), 0);
    const Ball bone = capsule({0, 0, 0}, {0, 3, 0}, 1);
    const Pose up = at(0, 0, 5), down{quarter(), Vec3(0, 0, 0)};
    const auto contact = cast(moving(bone, up, down), Moving<HalfSpace>(ground, Pose(), Pose()));
    ASSERT_TRUE(contact.has_value());
    EXPECT_EQ(contact->time, 0.8);
    EXPECT_EQ(contact->a, (Feature{Feature::Kind::vertex, 0, 0})) << "of two vertices the first";
    EXPECT_THROW(
        std::ignore = cast(moving(bone, up, down), Moving<HalfSpace>(ground, Pose(), Pose{quarter(), {0, 0, 0}})),
        NotSupported);
}

// ---- worlds

TEST(RoundedMoves, InAWorld) {
    World world;
    const BodyId ball = world.create_body(sphere(1), Pose());
    const BodyId wall = world.create_body(scenes::cube(1), at(10));
    const std::vector<BodyId> listed{ball, wall};
    const Pose turned_wall{quarter(), Vec3(10, 0, 0)};
    const auto met = world.meetings(listed, std::vector<Pose>{{quarter(), Vec3(16, 0, 0)}, at(10)});
    ASSERT_EQ(met.size(), 1U);
    EXPECT_EQ(met[0].contact.time, 0.5);
    EXPECT_EQ(world.cast(ball, Straight{{quarter(), Vec3(16, 0, 0)}})->contact.time, 0.5);
    EXPECT_EQ(world.cast({sphere(1), at(0, 5)}, Straight{at(0, -5)})->body, ball);
    const auto refuses = [&](const auto& ask) { EXPECT_THROW(std::ignore = ask(), NotSupported); };
    // A cube that turns is refused beside any ball, also far away; and so is a capsule beside any cube.
    refuses([&] { return world.meetings(listed, std::vector<Pose>{Pose(), turned_wall}); });
    refuses([&] { return world.cast(wall, Straight{turned_wall}); });
    refuses([&] {
        return world.cast({capsule({0, 0, 0}, {1, 0, 0}, 1), at(500)}, Straight{{quarter(), {500, 0, 0}}});
    });
    // Not if none has a radius, or none is left.
    world.set_shape(ball, sphere(0));
    EXPECT_EQ(world.meetings(listed, std::vector<Pose>{Pose(), turned_wall}).size(), 0U);
    world.set_shape(ball, sphere(1));
    world.destroy_body(wall);
    EXPECT_EQ(world.cast(ball, Straight{at(16)}), std::nullopt);
    EXPECT_EQ(world.meetings(std::vector{ball}, std::vector<Pose>{at(16)}).size(), 0U);
    const BodyId ground = world.create_body(std::make_shared<const HalfSpace>(Vec3::UnitZ(), -3.0), Pose());
    const BodyId bone = world.create_body(capsule({0, 0, 0}, {3, 0, 0}, 1), at(50));
    const auto landed = world.meetings(std::vector{bone}, std::vector<Pose>{at(50, 0, -4)});
    ASSERT_EQ(landed.size(), 1U);
    EXPECT_EQ(landed[0].bodies, (BodyPair{ground, bone}));
    EXPECT_EQ(landed[0].contact.time, 0.5);
}

TEST(RoundedMoves, TheSameInEveryEnvironment) {
    const Ball a = around(scenes::torus(6, 5, 0.4), 0.3), b = sphere(0.7, {0.1, 0.2, 0.3});
    const Pose from{Mat3::Identity() * 1.1, Vec3(0.3, 0.1, 0.7)}, to{Mat3::Identity() * 1.1, Vec3(5.1, 0.9, -0.2)};
    const Pose turned{quarter() * 0.3, Vec3(3.3, 0.1, 0)};
    const auto expected = cast(moving(a, from, to), moving(b, at(4), turned));
    ASSERT_TRUE(expected.has_value());
    const HalfSpace tilted(Vec3(0.1, 0.3, 0.9), -4);
    const auto landed = cast(moving(b, at(4), {quarter(), Vec3(0, 0, -9)}), Moving<HalfSpace>(tilted, Pose(), at(1)));
    ASSERT_TRUE(landed.has_value());
    const auto ask = [&] {
        return std::pair(cast(moving(a, from, to), moving(b, at(4), turned)),
                         cast(moving(b, at(4), {quarter(), Vec3(0, 0, -9)}), Moving<HalfSpace>(tilted, Pose(), at(1))));
    };
    environment::in_each_environment(ask, [&](const auto& got, const std::string& where) {
        EXPECT_EQ(got.first, expected) << where;
        EXPECT_EQ(got.second, landed) << where;
    });
}

}  // namespace
}  // namespace ecods::rounded_moves_test
