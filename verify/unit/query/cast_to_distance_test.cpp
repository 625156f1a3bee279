// Casts to a distance: known answers, and random bodies against the oracle.
#include "ecods/cast.hpp"
#include "ecods/rounded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "environment/each_environment.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/near_times.hpp"

namespace ecods {
namespace {

using Contact = std::optional<FirstContact>;

// Casts a to b, and b to a the other way; the limits of time beside the answer decide as it says.
template <class A, class B>
Contact cast_both(const Posed<A>& a, const Vec3& motion, const Posed<B>& b, double d) {
    const Contact found = cast_to_distance(a, motion, b, d), back = cast_to_distance(b, Vec3(-motion), a, d);
    EXPECT_EQ(found.has_value(), back.has_value());
    if (!found || !back) return std::nullopt;
    EXPECT_EQ(found->time, back->time);
    EXPECT_EQ(found->kind, back->kind);
    const double after = std::nextafter(found->time, 2), before = std::nextafter(found->time, 0);
    EXPECT_EQ(cast_to_distance(a, motion, b, d, after), found);
    EXPECT_TRUE(found->time <= 0 || !cast_to_distance(a, motion, b, d, before));
    return found;
}
template <class A, class B>
std::optional<double> time_of(const Posed<A>& a, const Vec3& motion, const Posed<B>& b, double d) {
    const Contact found = cast_both(a, motion, b, d);
    return found ? std::optional(found->time) : std::nullopt;
}

TEST(CastToDistance, KnownAnswers) {
    const ConvexSolid cube(scenes::cube(0.5));
    const MeshShape surface(cube.mesh_ptr());
    const Posed<MeshShape> there(cube, at(5)), there_too(surface, at(5));
    // The gap is 4 at the start, and 4 - 8 s.
    for (const auto& body : {Posed<MeshShape>(cube, Pose()), Posed<MeshShape>(surface, Pose())}) {
        EXPECT_EQ(time_of(body, {8, 0, 0}, there, 2), 0.25);
        EXPECT_EQ(time_of(body, {8, 0, 0}, there_too, 2), 0.25);
        EXPECT_EQ(time_of(body, {8, 0, 0}, there, 4), 0) << "at that distance at the start";
        EXPECT_EQ(time_of(body, {8, 0, 0}, there, std::nextafter(4, 0)), 0x1p-54);
        EXPECT_EQ(time_of(body, {2, 0, 0}, there, 2), 1) << "at the end";
        EXPECT_EQ(time_of(body, {2, 0, 0}, there, std::nextafter(2, 0)), std::nullopt);
        EXPECT_EQ(time_of(body, {-8, 0, 0}, there, 2), std::nullopt) << "away from it";
        EXPECT_EQ(time_of(body, {0, 0, 0}, there, 2), std::nullopt) << "at rest";
        EXPECT_EQ(time_of(body, {0, 0, 0}, there, 4), 0);
        EXPECT_EQ(time_of(body, {8, 0, 0}, there, 0), 0.5) << "as a cast";
        // It passes beside the other one, at the gap 2.
        const Posed<MeshShape> beside(cube, at(5, 3, 0));
        EXPECT_EQ(time_of(body, {16, 0, 0}, beside, 2), 0.25) << "grazes";
        EXPECT_EQ(time_of(body, {16, 0, 0}, beside, std::nextafter(2, 0)), std::nullopt);
        EXPECT_EQ(time_of(body, {16, 0, 0}, beside, 2.5), 0.15625) << "at (1.5, 2), which is 2.5 long";
    }
    const Contact first = cast_both(Posed<MeshShape>(cube, Pose()), {8, 0, 0}, there, 2);
    EXPECT_EQ(first->kind, ClosestKind::vertex_vertex);
    const Contact at_start = cast_both(Posed<MeshShape>(cube, Pose()), {8, 0, 0}, there, 4);
    EXPECT_EQ(at_start->kind, closest(Posed<MeshShape>(cube, Pose()), there).kind);
}

TEST(CastToDistance, WhatIsInsideHasTheDistanceZero) {
    const ConvexSolid room(scenes::cube(4)), cube(scenes::cube(0.5));
    const MeshShape walls(room.mesh_ptr());
    const Posed<MeshShape> inside(cube, Pose());
    const Contact contained = cast_both(inside, {8, 0, 0}, Posed<MeshShape>(room, Pose()), 0.25);
    EXPECT_EQ(contained->time, 0);
    EXPECT_EQ(contained->kind, ClosestKind::contained);
    // Between walls, which are 3.5 away.
    EXPECT_EQ(time_of(inside, {8, 0, 0}, Posed<MeshShape>(walls, Pose()), 1.5), 0.25);
    EXPECT_EQ(time_of(inside, {8, 0, 0}, Posed<MeshShape>(walls, Pose()), 3.5), 0);
}

// Radii and distance are added exactly.
TEST(CastToDistance, OfRoundedBodies) {
    const auto ball = sphere(3), small = sphere(0x1p-60);
    const Posed<Rounded> a(ball, Pose());
    EXPECT_EQ(time_of(a, {10, 0, 0}, Posed<Rounded>(sphere(1), at(8, 3, 0)), 1), 0.4);
    EXPECT_EQ(time_of(a, {4, 0, 0}, Posed<Rounded>(small, at(8)), 1 - 0x1p-60), 1) << "3 + 2^-60 + 1 - 2^-60 = 4";
    EXPECT_EQ(time_of(a, {4, 0, 0}, Posed<Rounded>(small, at(8)), 1 - 0x1p-53), std::nullopt);
    EXPECT_EQ(time_of(a, {4, 0, 0}, Posed<Rounded>(sphere(0), at(8)), 1), 1);
    const ConvexSolid cube(scenes::cube(0.5));
    EXPECT_EQ(time_of(Posed<Rounded>(sphere(0.5), Pose()), {8, 0, 0}, Posed<MeshShape>(cube, at(5)), 2), 0.25);
    EXPECT_EQ(time_of(Posed<MeshShape>(cube, Pose()), {8, 0, 0}, Posed<Rounded>(sphere(0.5), at(5)), 2), 0.25);
    EXPECT_EQ(cast_to_distance(a, {10, 0, 0}, Posed<Rounded>(sphere(2), at(8, 3, 0)), 0),
              cast(a, {10, 0, 0}, Posed<Rounded>(sphere(2), at(8, 3, 0))));
}

TEST(CastToDistance, ZeroIsACast) {
    const MeshShape ring(scenes::torus(20, 10, 0.25));
    const ConvexSolid cube(scenes::cube(0.5));
    scenes::Random random(71);
    for (int i = 0; i < 40; ++i) {
        Pose pose = random.turned();
        pose.t = random.direction() * random.uniform(0, 4);
        const Vec3 motion = -pose.t + random.direction();
        QueryCounts of_cast, of_distance;
        const auto expected = cast(Posed<MeshShape>(cube, pose), motion, Posed<MeshShape>(ring, Pose()), 1, of_cast);
        for (const double zero : {0.0, -0.0}) {
            QueryCounts counts;
            EXPECT_EQ(
                cast_to_distance(Posed<MeshShape>(cube, pose), motion, Posed<MeshShape>(ring, Pose()), zero, 1, counts),
                expected);
            of_distance = counts;
        }
        EXPECT_EQ(of_distance, of_cast);
    }
}

// Triangles, segments and points in general position and on the lattice.
TEST(CastToDistance, RandomTrianglesAsTheOracle) {
    scenes::Random random(72);
    int found_count = 0, none_count = 0;
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const bool on_lattice = i % 2 == 0;
        const auto point = [&] {
            if (on_lattice) return Vec3(random.below(4), random.below(4), random.below(4));
            return Vec3(random.direction() * random.uniform(0, 2));
        };
        const auto body = [&] {
            const Vec3 p = point(), q = random.below(3) == 0 ? p : point(), r = random.below(3) == 0 ? q : point();
            return std::make_shared<const MeshShape>(scenes::one_triangle({p, q, r}));
        };
        const auto a = body(), b = body();
        Pose pose = on_lattice ? Pose() : random.turned();
        if (i % 5 == 0) pose.R(0, 1) += 0.5;
        pose.t = on_lattice ? Vec3(9, random.below(4), 0) : Vec3(random.direction() * random.uniform(3, 8));
        const Vec3 motion = on_lattice ? Vec3(-16, 0, 0) : Vec3(-1.5 * pose.t + random.direction());
        const double d = on_lattice ? 0.5 * (1 + random.below(4)) : random.uniform(0, 1.5);
        const Posed<MeshShape> x(a, pose), y(b, Pose());
        if (within(x, y, d)) continue;
        const Contact found = cast_both(x, motion, y, d);
        const auto expected = near_times::first_within(x, motion, y, oracle::exactly(d));
        ASSERT_EQ(found.has_value(), expected.has_value());
        ++(found ? found_count : none_count);
        EXPECT_TRUE(!found || found->time == *expected);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(found_count, 80);
    EXPECT_GT(none_count, 10);
}

// Just before the time the bodies are further apart, as distances of doubles near it say: up to rounding of the pose.
TEST(CastToDistance, MeshesAreNearAtTheTime) {
    const MeshShape ball(scenes::sphere(12, 7));
    const Solid solid(scenes::sphere(8, 5));
    scenes::Random random(73);
    QueryMemory memory;
    PairWitness witness;
    int found_count = 0;
    for (int i = 0; i < 30; ++i) {
        Pose pose = random.turned();
        pose.t = random.direction() * random.uniform(3, 5);
        const Vec3 motion = -1.25 * pose.t + random.direction();
        const double d = i % 6 == 0 ? 0x1p-40 : random.uniform(0, 0.9);
        const Posed<MeshShape> a(ball, pose), b(solid, Pose());
        const Contact found = cast_to_distance(a, motion, b, d, 1, {memory, witness});
        EXPECT_EQ(cast_to_distance(a, motion, b, d), found) << "without a witness";
        if (!found) continue;
        ++found_count;
        Pose then = pose;
        then.t += found->time * motion;
        EXPECT_NEAR(distance({ball, then}, b), d, 0x1p-48);
        for (const double share : {0.0, 0.25, 0.5, 0.75, 0.99}) {
            then.t = pose.t + share * found->time * motion;
            EXPECT_GT(distance({ball, then}, b), d);
        }
    }
    EXPECT_GT(found_count, 15);
}

TEST(CastToDistance, Errors) {
    const MeshShape cube(scenes::cube(0.5));
    const Posed<MeshShape> a(cube, Pose()), b(cube, at(5));
    const Posed<Rounded> ball(sphere(1), Pose());
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double d : {-1.0, -0x1p-1074, nan, infinity}) {
        try {
            static_cast<void>(cast_to_distance(a, {1, 0, 0}, b, d));
            ADD_FAILURE() << d;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::distance);
        }
        EXPECT_THROW((void)cast_to_distance(ball, {1, 0, 0}, b, d), InvalidArgument);
        EXPECT_THROW((void)cast_to_distance(a, {1, 0, 0}, ball, d), InvalidArgument);
        EXPECT_THROW((void)cast_to_distance(ball, {1, 0, 0}, ball, d), InvalidArgument);
    }
    EXPECT_THROW((void)cast_to_distance(a, {nan, 0, 0}, b, 1), InvalidArgument);
    EXPECT_THROW((void)cast_to_distance(a, {nan, 0, 0}, b, 0), InvalidArgument);
    EXPECT_THROW((void)cast_to_distance(a, {1, 0, 0}, b, 1, nan), InvalidArgument);
    EXPECT_THROW((void)cast_to_distance(a, {1, 0, 0}, b, 1, -1), InvalidArgument);
    EXPECT_EQ(cast_to_distance(a, {3, 0, 0}, b, 1, 7)->time, 1);
    EXPECT_EQ(cast_to_distance(a, {3, 0, 0}, b, std::numeric_limits<double>::max())->time, 0);
}

TEST(CastToDistance, TheSameInEveryEnvironment) {
    const MeshShape ring(scenes::torus(9, 5, 0.25));
    const ConvexSolid cube(scenes::cube(1));
    struct Asked {
        Posed<MeshShape> a, b;
        Vec3 motion;
        double d;
    };
    std::vector<Asked> asked;
    for (const double unit : {1.0, 0x1p-1060, 0x1p1000}) {
        const Pose pose(unit * Mat3::Identity(), Vec3::Zero());
        const Pose there(unit * Mat3::Identity(), unit * Vec3(5, 0.5, 0.25));
        asked.push_back({{ring, there}, {cube, pose}, unit * Vec3(-6, 0.125, -0.25), unit * 0.375});
    }
    const auto ask = [&] {
        std::vector<Contact> all;
        for (const auto& [a, b, motion, d] : asked) all.push_back(cast_to_distance(a, motion, b, d));
        return all;
    };
    const auto expected = ask();
    EXPECT_TRUE(expected[0] && expected[0]->time > 0);
    EXPECT_EQ(expected[1], expected[0]);
    EXPECT_EQ(expected[2], expected[0]);
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
}

}  // namespace
}  // namespace ecods
