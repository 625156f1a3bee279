// The body that a translated subject enters first, and where it touches bodies first, against asking all bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_entering_test {
namespace {

class WorldEnteringTest : public EachWorld {
  protected:
    Posed<MeshShape> mesh_of(BodyId body) const {
        return {std::dynamic_pointer_cast<const MeshShape>(world.shape(body)), world.pose(body)};
    }
    std::optional<BodyEntry> of_each(BodyId a, const Vec3& motion, double max_time) const {
        std::optional<BodyEntry> first;
        for (const BodyId b : world.bodies()) {
            if (b == a) continue;
            const auto entry = entering(mesh_of(a), motion, mesh_of(b), max_time);
            if (entry && (!first || entry->time < first->entry.time)) first = BodyEntry{b, *entry};
        }
        return first;
    }
    // Expects the answers with several limits. Counts entries.
    void expect_as_each(const std::shared_ptr<const Shape>& shape, int& found, int& later) {
        scenes::Random random(44);
        for (int i = 0; i < 24; ++i) {
            world.create_body(shape, at(1.5 * random.below(5), 1.5 * random.below(5), 1.5 * random.below(3)));
        }
        for (const BodyId a : world.bodies()) {
            const Vec3 motion(4 * random.below(3) - 4.0, 8 * random.below(3) - 8.0, random.below(2));
            const auto whole = of_each(a, motion, 1);
            EXPECT_EQ(world.entering(a, motion), whole);
            for (const double limit : {0.0, 0.125, 0.5, 7.0}) {
                EXPECT_EQ(world.entering(a, motion, limit, memory), of_each(a, motion, limit)) << limit;
            }
            if (!whole) continue;
            const double time = whole->entry.time;
            EXPECT_EQ(world.entering(a, motion, std::nextafter(time, 2)), whole) << "before a later time";
            if (time > 0) {
                EXPECT_EQ(world.entering(a, motion, time), of_each(a, motion, time));
            }
            ++found;
            later += time > 0;
        }
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldEnteringTest, broad_phases(), broad_phase_name);

// On a lattice many times tie, at time 0 and later.
TEST_P(WorldEnteringTest, IsThatOfTheFirstBody) {
    int found = 0, later = 0;
    expect_as_each(std::make_shared<const ConvexSolid>(cube), found, later);
    EXPECT_GT(found, 5);
    EXPECT_GT(later, 3);
}
TEST_P(WorldEnteringTest, IsThatOfTheFirstSurface) {
    const auto sheet = Mesh::create({{-0.75, -0.5, 0}, {0.75, -0.25, 0.25}, {0, 0.75, -0.25}}, {{0, 1, 2}});
    int found = 0, later = 0;
    expect_as_each(std::make_shared<const MeshShape>(sheet), found, later);
    EXPECT_GT(found, 3);
}

TEST_P(WorldEnteringTest, KnownTimesAndLimits) {
    const auto solid = std::make_shared<const ConvexSolid>(cube);
    const BodyId floor = world.create_body(solid, at(0)), moved = world.create_body(solid, at(5));
    const Vec3 motion(-8, 0, 0);
    const auto entry = world.entering(moved, motion);
    ASSERT_TRUE(entry);
    EXPECT_EQ(entry->body, floor);
    EXPECT_EQ(entry->entry.time, 0.5);
    EXPECT_EQ(world.entering(moved, motion, 0.5), std::nullopt) << "not before the limit";
    EXPECT_EQ(world.entering(moved, motion, std::nextafter(0.5, 1)), entry);
    world.set_pose(moved, at(0.5));
    EXPECT_EQ(world.entering(moved, motion, 0)->entry.time, 0) << "inner points are shared at the start";
    world.set_pair_enabled(floor, moved, false);
    EXPECT_EQ(world.entering(moved, motion), std::nullopt);
}

TEST_P(WorldEnteringTest, WhatIsWrongIsRefused) {
    const auto solid = std::make_shared<const ConvexSolid>(cube);
    const BodyId a = world.create_body(solid, at(0));
    const Vec3 motion(1, 0, 0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_INVALID(world.entering(a, Vec3(0, nan, 0)), Argument::motion);
    EXPECT_INVALID(world.entering(a, motion, -1), Argument::time);
    EXPECT_INVALID(world.entering(a, motion, nan), Argument::time);
    const BodyId surface = world.create_body(cube, at(100));
    EXPECT_THROW(std::ignore = world.entering(a, motion), NotSupported);
    world.set_pair_enabled(a, surface, false);
    EXPECT_EQ(world.entering(a, motion), std::nullopt) << "what it cannot meet does not count";
    world.create_body(std::make_shared<const HalfSpace>(Vec3(0, 0, 1), -100.0), Pose());
    EXPECT_THROW(std::ignore = world.entering(a, motion), NotSupported);
    EXPECT_THROW(std::ignore = world.contact_point(a, motion, {world.bodies().back(), {}}), NotSupported);
    world.destroy_body(a);
    EXPECT_THROW(std::ignore = world.entering(a, motion), StaleBody);
    EXPECT_THROW(std::ignore = world.contact_point(surface, motion, {a, {}}), StaleBody);
}

// Bodies of all kinds that touch first, and where: that of two.
TEST_P(WorldEnteringTest, PointsOfContactAreThoseOfTwo) {
    scenes::Random random(45);
    const auto solid = std::make_shared<const ConvexSolid>(cube);
    const std::shared_ptr<const Shape> shapes[] = {solid, sphere(0.5), rounded(solid, 0.25),
                                                   capsule({-1, 0, 0}, {1, 0, 0}, 0.25)};
    for (int i = 0; i < 24; ++i) {
        world.create_body(shapes[i % 4], at(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)));
    }
    int round = 0, others = 0;
    std::vector<BodyId> moved = world.bodies();
    for (int i = 0; i < 48; ++i) moved.push_back(moved[static_cast<std::size_t>(i)]);
    for (const BodyId a : moved) {
        const Vec3 motion(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
        const auto met = world.cast(a, motion);
        if (!met) continue;
        const auto expected = [&](const auto& x) {
            const auto second = std::dynamic_pointer_cast<const Rounded>(world.shape(met->body));
            const Pose pose = world.pose(met->body);
            return second ? contact_point(x, motion, Posed<Rounded>(second, pose), met->contact)
                          : contact_point(x, motion, mesh_of(met->body), met->contact);
        };
        const auto first = std::dynamic_pointer_cast<const Rounded>(world.shape(a));
        const ContactPoint point = world.contact_point(a, motion, *met);
        EXPECT_EQ(point, first ? expected(Posed<Rounded>(first, world.pose(a))) : expected(mesh_of(a)));
        EXPECT_EQ(point.normal.has_value(), met->contact.time > 0);
        (first ? round : others) += point.normal.has_value();
    }
    EXPECT_GT(round, 5);
    EXPECT_GT(others, 1);
}

}  // namespace
}  // namespace ecods::world_entering_test
