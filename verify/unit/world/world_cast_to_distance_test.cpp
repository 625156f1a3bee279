// The body that a translated subject is first within a distance of, against asking all bodies one by one.
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_cast_to_distance_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class WorldCastToDistanceTest : public EachWorld {
  protected:
    // Returns the contact of two bodies.
    std::optional<FirstContact> of_pair(BodyId a, const Vec3& motion, BodyId b, double distance) const {
        const auto first = world.shape(a), second = world.shape(b);
        const auto ask = [&](const auto& x) {
            if (const auto* y = dynamic_cast<const Rounded*>(second.get())) {
                return cast_to_distance(x, motion, Posed<Rounded>(*y, world.pose(b)), distance);
            }
            const auto& mesh = dynamic_cast<const MeshShape&>(*second);
            return cast_to_distance(x, motion, Posed<MeshShape>(mesh, world.pose(b)), distance);
        };
        if (const auto* x = dynamic_cast<const Rounded*>(first.get())) return ask(Posed<Rounded>(*x, world.pose(a)));
        return ask(Posed<MeshShape>(dynamic_cast<const MeshShape&>(*first), world.pose(a)));
    }

    std::optional<BodyContact> of_each(BodyId a, const Vec3& motion, double distance) const {
        std::optional<BodyContact> first;
        for (const BodyId b : world.bodies()) {
            if (b == a) continue;
            const auto contact = of_pair(a, motion, b, distance);
            if (contact && (!first || contact->time < first->contact.time)) first = BodyContact{b, *contact};
        }
        return first;
    }
};

TEST_P(WorldCastToDistanceTest, IsThatOfTheFirstBody) {
    scenes::Random random(36);
    const auto solid = std::make_shared<const ConvexSolid>(cube->vertices());
    for (int i = 0; i < 24; ++i) {
        const Pose pose = at(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-6, 6));
        if (i % 3 == 0) world.create_body(cube, pose);
        if (i % 3 == 1) world.create_body(solid, pose);
        if (i % 3 == 2) world.create_body(sphere(random.uniform(0, 1)), pose);
    }
    int found = 0, later = 0;
    for (const BodyId a : world.bodies()) {
        for (const double distance : {0.0, 0x1p-1074, 0.25, 1.5}) {
            const Vec3 motion(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
            const auto expected = of_each(a, motion, distance);
            EXPECT_EQ(world.cast_to_distance(a, motion, distance), expected);
            found += expected.has_value();
            later += expected && expected->contact.time > 0;
        }
    }
    EXPECT_GT(found, 40);
    EXPECT_GT(later, 20);
}

// A cube at x = 5 goes by -4 towards one at 0, and one further away is passed over.
TEST_P(WorldCastToDistanceTest, KnownTimes) {
    const BodyId near = world.create_body(cube, at(0)), far = world.create_body(cube, at(-3));
    const BodyId moved = world.create_body(cube, at(5));
    const Vec3 motion(-4, 0, 0);
    const auto contact = world.cast_to_distance(moved, motion, 0.5);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, near);
    EXPECT_EQ(contact->contact.time, 0.875);
    EXPECT_EQ(world.cast_to_distance(moved, motion, 0.5, 0.874), std::nullopt);
    EXPECT_EQ(world.cast_to_distance(moved, motion, 0), world.cast(moved, motion));
    EXPECT_EQ(world.cast_to_distance(moved, Vec3(0, 0, 0), 3), std::nullopt);
    const auto at_start = world.cast_to_distance(moved, motion, 1e308);
    ASSERT_TRUE(at_start);
    EXPECT_EQ(at_start->contact.time, 0);
    EXPECT_EQ(at_start->body, near);
    world.set_filter(moved, {.groups = 2, .mask = 2});
    EXPECT_EQ(world.cast_to_distance(moved, motion, 0.5), std::nullopt);
    world.set_filter(far, {.groups = 2, .mask = 2});
    EXPECT_EQ(world.cast_to_distance(moved, motion, 3.5)->body, far);
}

TEST_P(WorldCastToDistanceTest, WhatIsWrongIsRefused) {
    const BodyId body = world.create_body(cube, at(0));
    const Vec3 motion(1, 0, 0);
    EXPECT_INVALID(world.cast_to_distance(body, motion, -1), Argument::distance);
    EXPECT_INVALID(world.cast_to_distance(body, motion, std::numeric_limits<double>::quiet_NaN()), Argument::distance);
    EXPECT_INVALID(world.cast_to_distance(body, motion, infinity), Argument::distance);
    EXPECT_INVALID(world.cast_to_distance(body, Vec3(0, infinity, 0), 1), Argument::motion);
    EXPECT_INVALID(world.cast_to_distance(body, motion, 1, -1), Argument::time);
    world.create_body(std::make_shared<const HalfSpace>(Vec3(0, 0, 1), -100.0), Pose());
    EXPECT_THROW(std::ignore = world.cast_to_distance(body, motion, 1), NotSupported);
    world.destroy_body(body);
    EXPECT_THROW(std::ignore = world.cast_to_distance(body, motion, 1), StaleBody);
}

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldCastToDistanceTest, broad_phases(), broad_phase_name);

}  // namespace
}  // namespace ecods::world_cast_to_distance_test
