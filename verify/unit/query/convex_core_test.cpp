// The convex cores of rounded bodies are kept with their shapes, and questions about cores that meet begin with them.
#include "query/convex/convex_core.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "ecods/builders.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"

namespace ecods {
namespace {

const ConvexSolid* core_of(const Rounded& body, const Pose& pose = {}) {
    return convex::convex_core(Posed<MeshShape>(body.core(), pose)).what;
}

TEST(ConvexCore, IsMadeOnce) {
    const auto bone = capsule({0, 0, -1}, {0, 0, 1}, 0.25);
    const ConvexSolid* const core = core_of(*bone);
    EXPECT_EQ(core_of(*bone, at(3)), core);
    EXPECT_EQ(core->dimension(), 1);
    EXPECT_EQ(&core->mesh(), &bone->core().mesh());
    // A shape with another radius has the same core; a core of its own has its own.
    EXPECT_EQ(core_of(*rounded(bone, 0.5)), core);
    EXPECT_NE(core_of(*capsule({0, 0, -1}, {0, 0, 1}, 0.25)), core);
    // A convex solid is its own core.
    const auto solid = box(Vec3(1, 1, 1));
    EXPECT_EQ(core_of(*rounded(solid, 0.5)), solid.get());
}

TEST(ConvexCore, ManyThreadsGetTheSame) {
    for (int i = 0; i < 20; ++i) {
        const auto ball = sphere(1, {1, 2, 3});
        std::array<const ConvexSolid*, 4> cores{};
        std::vector<std::thread> threads;
        for (const ConvexSolid*& core : cores) threads.emplace_back([&ball, &core] { core = core_of(*ball); });
        for (std::thread& thread : threads) thread.join();
        for (const ConvexSolid* const core : cores) EXPECT_EQ(core, core_of(*ball));
    }
}

// Expects the number, the points and the work of two convex solids, of cores that share a point.
void expect_as_solids(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Posed<ConvexSolid>& solid) {
    const Posed<ConvexSolid> core(*core_of(*a.what), a.pose);
    QueryCounts of_rounded, of_solids;
    PairWitness witness, other;
    QueryMemory memory;
    const SignedDistance found = signed_distance(a, b, {memory, witness, of_rounded});
    const SignedDistance expected = signed_distance(core, solid, {memory, other, of_solids});
    ASSERT_LE(expected.distance, 0);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(of_rounded, of_solids) << "no triangles are searched";
    const auto deep = depth(a, b);
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->depth, -expected.distance);
}

// A body without a radius is its core, so that the answers are equal to the last bit.
TEST(ConvexCore, MeetingCoresAreAskedAboutAsSolids) {
    scenes::Random random(3);
    const auto solid = box(Vec3(2, 3, 4));
    for (int i = 0; i < 60; ++i) {
        const auto bone = capsule(random.direction() * 0.5, random.direction() * 0.5, 0);
        const Pose pose = random.turned(), there(random.turned().R, random.direction() * random.uniform(0, 0.4));
        expect_as_solids({*bone, pose}, {*solid, there}, {*solid, there});
        if (HasFailure()) return;
    }
}

// A ball's center beside a face, on it, and in it, by the last digits: the number is that of the face.
TEST(ConvexCore, CoresThatNearlyMeet) {
    const auto solid = box(Vec3(2, 2, 2));
    const auto ball = sphere(0.25), point = sphere(0);
    for (const double off : {0.0, 0x1p-52, -0x1p-53, 0x1p-30, -0x1p-30}) {
        for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0, -1, 0)}) {
            const Pose there = at(Vec3((1 + off) * along));
            EXPECT_EQ(signed_distance({*ball, there}, Posed<MeshShape>(*solid, Pose())).distance, off - 0.25);
            const SignedDistance found = signed_distance({*point, there}, Posed<MeshShape>(*solid, Pose()));
            EXPECT_EQ(found.distance, off);
            EXPECT_FALSE(std::signbit(found.distance) && found.distance == 0);
            EXPECT_EQ(found.direction, Vec3(-along));
            EXPECT_EQ(depth({*ball, there}, Posed<MeshShape>(*solid, Pose()))->depth, 0.25 - off);
        }
    }
}

// A part of a core that a pose flattens is inside the other one: only such cores are searched for parts inside.
TEST(ConvexCore, SingularPosesAreNamed) {
    const auto solid = box(Vec3(2, 2, 2));
    const auto ball = sphere(0.25);
    Pose flat;
    flat.R(1, 1) = 0;
    const auto expect_named = [](const auto& a, const auto& b, int argument) {
        try {
            (void)signed_distance(a, b);
            FAIL();
        } catch (const SingularPose& error) {
            EXPECT_EQ(error.argument, argument);
        }
    };
    expect_named(Posed<Rounded>(*ball, flat), Posed<MeshShape>(*solid, Pose()), 0);
    expect_named(Posed<MeshShape>(*solid, Pose()), Posed<Rounded>(*ball, flat), 1);
    expect_named(Posed<Rounded>(*ball, Pose()), Posed<MeshShape>(*solid, flat), 1);
    flat.t = Vec3(3, 0, 0);
    EXPECT_EQ(signed_distance(Posed<Rounded>(*ball, flat), Posed<MeshShape>(*solid, Pose())).distance, 1.75);
}

}  // namespace
}  // namespace ecods
