// Casts by a translation of every family of cast_cases.hpp beside the oracle, and what must not matter.
#include <gtest/gtest.h>

#include <string_view>

#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

TEST(CastFamilies, AsTheOracle) {
    const auto count = [](std::string_view family) { return family == "bodies of distances" ? 250 : 100; };
    expect_each(expect_all_right(scenes::cast_families(), 1, count), 6, 15);
}

TEST(CastFamilies, TheSameBitsInEveryEnvironment) {
    expect_all_right_everywhere(scenes::cast_families(), 2, 8, 1);
}

// Trees of several levels: bodies that are sent at each other and past each other.
TEST(CastFamilies, LargerMeshesAsTheOracle) {
    const MeshShape sphere(scenes::sphere(10, 6)), torus(scenes::torus(10, 6, 0.4));
    scenes::Random random(3);
    QueryMemory memory;
    PairWitness witness;
    for (int i = 0; i < 16; ++i) {
        Pose a = random.turned(), b = random.turned();
        a.t = 4 * random.direction();
        const Vec3 motion = (i % 2 == 0 ? -1.0 : -0.75) * a.t + (i % 3) * random.direction();
        ASSERT_NO_FATAL_FAILURE(expect_right(judge::CastTruth({torus, a}, motion, {sphere, b}), memory, witness)) << i;
    }
}

// What comes later than the first contact does not matter: half the motion takes the time twice as long, exactly.
TEST(CastFamilies, TimesOfShorterMotions) {
    const MeshShape torus(scenes::torus(24, 16, 0.4)), sphere(scenes::sphere(24, 16));
    scenes::Random random(4);
    QueryMemory memory;
    int contacts = 0;
    for (int i = 0; i < 200; ++i) {
        Pose a = random.turned(), b = random.turned();
        a.t = 4 * random.direction();
        const Vec3 motion = -a.t + 2 * random.direction();
        const auto whole = cast({torus, a}, motion, {sphere, b}, 1, memory);
        const auto doubled = cast({torus, a}, 2 * motion, {sphere, b}, 1, memory);
        const auto half = cast({torus, a}, 0.5 * motion, {sphere, b}, 1, memory);
        if (!whole) {
            EXPECT_FALSE(half);
            continue;
        }
        ++contacts;
        ASSERT_TRUE(doubled);
        EXPECT_EQ(2 * doubled->time, whole->time);
        EXPECT_EQ(doubled->a, whole->a);
        EXPECT_EQ(doubled->b, whole->b);
        ASSERT_EQ(half.has_value(), whole->time <= 0.5);
        if (half) {
            EXPECT_EQ(half->time, 2 * whole->time);
        }
    }
    EXPECT_GT(contacts, 100);
}

// The time as a factor of the motion, and a body that has been moved there.
TEST(CastFamilies, OwnAnswersAsArguments) {
    std::size_t asked = 0;
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(scenes::cast_families(), 5, 25, [&](const scenes::CastCase& made) {
        const MeshShape a(made.a), b(made.b);
        const auto contact = cast({a, made.pose_a}, made.motion, {b, made.pose_b}, 1, memory);
        if (!contact) return;
        const Vec3 motion = contact->time * made.motion;
        Pose there = made.pose_a;
        there.t += motion;
        if (!there.t.allFinite()) return;
        ++asked;
        expect_right(judge::CastTruth({a, made.pose_a}, motion, {b, made.pose_b}, 1), memory, witness);
        expect_right(judge::CastTruth({a, there}, -motion, {b, made.pose_b}, 1), memory, witness);
    });
    EXPECT_GT(asked, 60U);
}

}  // namespace
}  // namespace ecods
