// The body that a deforming mesh meets first, against asking all bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_deforming_test {
namespace {

class WorldDeformingTest : public EachWorld {
  protected:
    std::optional<BodyContact> of_each(const Deforming& mesh, double max_time, const World::Filter& filter) const {
        std::optional<BodyContact> first;
        for (const BodyId b : world.bodies()) {
            if (filter && !may_meet(*filter, world.filter(b))) continue;
            const auto shape = std::dynamic_pointer_cast<const MeshShape>(world.shape(b));
            const auto contact = cast(mesh, {shape, world.pose(b)}, max_time);
            if (contact && (!first || contact->time < first->contact.time)) first = BodyContact{b, *contact};
        }
        return first;
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldDeformingTest, broad_phases(), broad_phase_name);

Deforming sheet(const Vec3& from, const Vec3& by, const Vec3& bend) {
    const std::vector<Vec3> corners{from, from + Vec3(1, 0, 0), from + Vec3(1, 1, 0), from + Vec3(0, 1, 0)};
    const auto mesh = Mesh::create(corners, {Triangle{0, 1, 2}, {0, 2, 3}});
    std::vector<Vec3> ends;
    for (std::size_t i = 0; i < 4; ++i) ends.push_back(corners[i] + by + (i % 2 == 0 ? bend : Vec3(0, 0, 0)));
    return Deforming(std::make_shared<const MeshShape>(mesh), ends);
}

TEST_P(WorldDeformingTest, IsThatOfTheFirstBody) {
    scenes::Random random(46);
    const auto any = [&] { return Vec3(random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-6, 6)); };
    for (int i = 0; i < 30; ++i) {
        Pose pose = random.turned();
        pose.t = any();
        const BodyId body = i % 2 == 0 ? world.create_body(cube, pose)
                                       : world.create_body(std::make_shared<const ConvexSolid>(cube), pose);
        if (i % 5 == 0) world.set_filter(body, {.groups = 2, .mask = 2});
    }
    int found = 0, later = 0;
    for (int i = 0; i < 150; ++i) {
        const Deforming mesh = sheet(any(), any(), 0.25 * any());
        World::Filter filter;
        if (i % 3 == 0) filter = CollisionFilter{.groups = 2, .mask = 2};
        for (const double limit : {0.0, 0.25, 1.0, 5.0}) {
            const auto expected = of_each(mesh, limit, filter);
            EXPECT_EQ(world.cast(mesh, limit, filter), expected);
            EXPECT_EQ(world.cast(mesh, limit, filter, memory), expected);
            found += expected.has_value();
            later += expected && expected->contact.time > 0;
        }
    }
    EXPECT_GT(found, 40);
    EXPECT_GT(later, 20);
}

// A sheet falls from 3.5 by 4 on two equal cubes at once: the lesser id.
TEST_P(WorldDeformingTest, KnownTimes) {
    const BodyId first = world.create_body(cube, at(0, 0, 0)), second = world.create_body(cube, at(1, 0, 0));
    const Deforming falls = sheet({0, 0, 3.5}, {0, 0, -4}, {0, 0, 0});
    EXPECT_EQ(falls.box(), (Aabb{Vec3(0, 0, -0.5), Vec3(1, 1, 3.5)}));
    const auto contact = world.cast(falls);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, first);
    EXPECT_EQ(contact->contact.time, 0.75);
    EXPECT_EQ(world.cast(falls, 0.75), contact);
    EXPECT_EQ(world.cast(falls, std::nextafter(0.75, 0)), std::nullopt);
    world.set_filter(first, {.groups = 2, .mask = 2});
    EXPECT_EQ(world.cast(falls, 1, CollisionFilter{.groups = 1, .mask = 1})->body, second);
    world.set_pose(second, at(1, 0, 0.25));
    EXPECT_EQ(world.cast(falls)->body, second) << "changes count at once";
    // A deforming mesh inside a solid meets it at once.
    const BodyId room = world.create_body(std::make_shared<const Solid>(scenes::cube(50)), Pose());
    EXPECT_EQ(world.cast(falls)->body, room);
    EXPECT_EQ(world.cast(falls)->contact.kind, ClosestKind::contained);
}

// Vertices that no triangle uses do not count; the box is that of the ends, whatever their signs of zero.
TEST_P(WorldDeformingTest, BoxesAreThoseOfTheTriangles) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const auto mesh = Mesh::create({{9, 9, 9}, {0, 0, 0}, {tiny, 0, -tiny}, {0, 1, 0}}, {{1, 2, 3}});
    const Deforming moves(std::make_shared<const MeshShape>(mesh), {{-9, -9, -9}, {0, 0, 0}, {0, 0, 0}, {0, 2, 0}});
    EXPECT_EQ(moves.box(), (Aabb{Vec3(0, 0, -tiny), Vec3(tiny, 2, 0)}));
}

TEST_P(WorldDeformingTest, WhatIsWrongIsRefused) {
    world.create_body(cube, at(0));
    const Deforming mesh = sheet({0, 0, 3.5}, {0, 0, -4}, {0, 0, 0});
    EXPECT_INVALID(world.cast(mesh, -1), Argument::time);
    EXPECT_INVALID(world.cast(mesh, std::numeric_limits<double>::quiet_NaN()), Argument::time);
    const BodyId ball = world.create_body(sphere(1), at(100));
    expect_not_supported([&] { std::ignore = world.cast(mesh); }, Question::cast_moving, ShapeKind::mesh(),
                         world.shape(ball)->kind());
    world.set_filter(ball, {.groups = 2, .mask = 2});
    EXPECT_TRUE(world.cast(mesh, 1, CollisionFilter{.groups = 1, .mask = 1})) << "what it cannot meet does not count";
    World moved(std::move(world));
    EXPECT_THROW(std::ignore = world.cast(mesh), MovedFromWorld);
}

}  // namespace
}  // namespace ecods::world_deforming_test
