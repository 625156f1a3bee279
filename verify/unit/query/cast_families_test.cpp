// Casts by a translation of every family of cast_cases.hpp beside the oracle, and what must not matter.
#include <gtest/gtest.h>

#include <array>

#include "judge/cast_truth.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

// One witness goes through all of them: it comes from other bodies each time.
TEST(CastFamilies, AsTheOracle) {
    std::array<int, 6> kinds{};
    for (const scenes::CastFamily family : scenes::cast_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(1);
        QueryMemory memory;
        PairWitness witness;
        const bool is_of_many = family == scenes::CastFamily::distance_cases;
        for (int i = 0; i < (is_of_many ? 250 : 100); ++i) {
            SCOPED_TRACE(i);
            const scenes::CastCase made = scenes::make_cast_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const judge::CastTruth truth({a, made.pose_a}, made.motion, {b, made.pose_b});
            if (made.time) {
                ASSERT_EQ(truth.contact() ? truth.contact()->time : -1, *made.time);
            }
            ++kinds[truth.contact() ? static_cast<std::size_t>(truth.contact()->kind) : 5];
            ASSERT_NO_FATAL_FAILURE(expect_right(truth, memory, witness));
        }
    }
    for (const int count : kinds) EXPECT_GT(count, 15);
}

// Neither instruction sets nor rounding modes matter, nor what a question leaves in the memory.
TEST(CastFamilies, TheSameBitsInEveryEnvironment) {
    for (const scenes::CastFamily family : scenes::cast_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(2);
        for (int i = 0; i < 8; ++i) {
            const scenes::CastCase made = scenes::make_cast_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const judge::CastTruth truth({a, made.pose_a}, made.motion, {b, made.pose_b}, 1);
            SCOPED_TRACE(i);
            expect_right_everywhere(truth);
        }
    }
}

// Trees of several levels: bodies that are sent at each other and past each other.
TEST(CastFamilies, LargerMeshesAsTheOracle) {
    const MeshShape sphere(scenes::sphere(10, 6)), torus(scenes::torus(10, 6, 0.4));
    scenes::Random random(3);
    QueryMemory memory;
    PairWitness witness;
    for (int i = 0; i < 16; ++i) {
        Pose a, b;
        a.R = random.rotation().toRotationMatrix();
        b.R = random.rotation().toRotationMatrix();
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
        Pose a, b;
        a.R = random.rotation().toRotationMatrix();
        b.R = random.rotation().toRotationMatrix();
        a.t = 4 * random.direction();
        const Vec3 motion = -a.t + 2 * random.direction();
        const auto whole = cast({torus, a}, motion, {sphere, b}, memory);
        const auto doubled = cast({torus, a}, 2 * motion, {sphere, b}, memory);
        const auto half = cast({torus, a}, 0.5 * motion, {sphere, b}, memory);
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
    for (const scenes::CastFamily family : scenes::cast_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(5);
        QueryMemory memory;
        PairWitness witness;
        for (int i = 0; i < 25; ++i) {
            const scenes::CastCase made = scenes::make_cast_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const auto contact = cast({a, made.pose_a}, made.motion, {b, made.pose_b}, memory);
            if (!contact) continue;
            const Vec3 motion = contact->time * made.motion;
            Pose there = made.pose_a;
            there.t += motion;
            if (!there.t.allFinite()) continue;
            ++asked;
            const judge::CastTruth shorter({a, made.pose_a}, motion, {b, made.pose_b}, 1);
            ASSERT_NO_FATAL_FAILURE(expect_right(shorter, memory, witness)) << i;
            const judge::CastTruth from_there({a, there}, -motion, {b, made.pose_b}, 1);
            ASSERT_NO_FATAL_FAILURE(expect_right(from_there, memory, witness)) << i;
        }
    }
    EXPECT_GT(asked, 60U);
}

}  // namespace
}  // namespace ecods
