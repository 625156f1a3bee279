// Distances of two bodies, and which body or pair is the nearest.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_nearest_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The two bodies and their distance; the points are asked in world_closest_test.cpp.
struct Near {
    BodyPair bodies;
    double distance;

    friend bool operator==(const Near&, const Near&) = default;
};

class WorldNearestTest : public EachWorld {
  protected:
    std::optional<Near> closest_pair(double max_distance = World::no_limit) const {
        const auto found = world.closest_pair(max_distance);
        return found ? std::optional(Near{found->bodies, found->distance}) : std::nullopt;
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldNearestTest, broad_phases(), broad_phase_name);

TEST_P(WorldNearestTest, TwoBodiesAreAskedInEitherOrder) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(4, 5));
    EXPECT_EQ(world.distance(a, b), 5);
    EXPECT_EQ(world.distance(b, a, memory), 5);
    EXPECT_TRUE(world.within(a, b, 5));
    EXPECT_FALSE(world.within(b, a, std::nextafter(5, 0), memory));
    EXPECT_TRUE(world.within(b, a, infinity));
    const ClosestPoints points = world.closest(a, b), mirrored = world.closest(b, a, memory);
    EXPECT_EQ(points.distance, 5);
    EXPECT_EQ(points.point_a, mirrored.point_b);
    EXPECT_EQ(points.point_b, mirrored.point_a);
    EXPECT_EQ(points.a, mirrored.b) << "ties are decided as if the lesser id came first";
    EXPECT_EQ(points.b, mirrored.a);
    EXPECT_THROW(static_cast<void>(world.distance(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.closest(a, BodyId{})), StaleBody);
    EXPECT_INVALID(world.within(a, b, -1), Argument::distance);
    EXPECT_INVALID(world.within(a, b, std::numeric_limits<double>::quiet_NaN()), Argument::distance);
}

TEST_P(WorldNearestTest, TheNearestIsOfNowAndTiesGoToTheLeastIds) {
    const BodyId a = world.create_body(cube, at(0));
    EXPECT_EQ(world.nearest(a), std::nullopt);
    EXPECT_EQ(closest_pair(), std::nullopt);
    const BodyId b = world.create_body(cube, at(3));
    const BodyId c = world.create_body(cube, at(0, 3));
    EXPECT_EQ(world.nearest(a), (NearestBody{b, 2}));
    EXPECT_EQ(world.nearest(c), (NearestBody{a, 2}));
    EXPECT_EQ(closest_pair(), (Near{{a, b}, 2}));
    world.set_pose(c, at(0, -2.5));
    EXPECT_EQ(world.nearest(a, World::no_limit, memory), (NearestBody{c, 1.5}));
    EXPECT_EQ(closest_pair(), (Near{{a, c}, 1.5}));
    EXPECT_EQ(world.nearest(a, 1.5), (NearestBody{c, 1.5}));
    EXPECT_EQ(world.nearest(a, std::nextafter(1.5, 0)), std::nullopt);
    EXPECT_EQ(world.closest_pair(1.5)->bodies, (BodyPair{a, c}));
    EXPECT_EQ(closest_pair(std::nextafter(1.5, 0)), std::nullopt);
    EXPECT_EQ(world.nearest(a, 0), std::nullopt);
}

// The root of 3 is above the double nearest to it, and the root of 2 below.
TEST_P(WorldNearestTest, TheLimitIsForTheRealDistance) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(2, 2, 2));
    const double root = world.distance(a, b);
    EXPECT_EQ(world.nearest(a, root), std::nullopt);
    EXPECT_EQ(world.nearest(a, std::nextafter(root, 2)), (NearestBody{b, root}));
    EXPECT_EQ(world.nearest({cube, at(0)}, 0), (NearestBody{a, 0}));
    EXPECT_EQ(closest_pair(root), std::nullopt);
    EXPECT_EQ(closest_pair(std::nextafter(root, 2)), (Near{{a, b}, root}));
    world.set_clearance(root);
    world.update();
    EXPECT_TRUE(world.close_pairs().empty());
    world.set_pose(b, at(2, 2));
    EXPECT_EQ(world.nearest(a, world.distance(a, b)), (NearestBody{b, world.distance(a, b)}));
    world.set_clearance(world.distance(a, b));
    world.update();
    EXPECT_EQ(world.close_pairs().size(), 1u);
}

TEST_P(WorldNearestTest, AmongBodiesThatMeetTheLeastIdsAreGiven) {
    for (int i = 0; i < 100; ++i) world.create_body(cube, at(0.0625 * (99 - i)));
    const auto bodies = world.bodies();
    EXPECT_EQ(world.nearest(bodies[50], 0), (NearestBody{bodies[34], 0})) << "the first that touches it";
    EXPECT_EQ(closest_pair(), (Near{{bodies[0], bodies[1]}, 0}));
    EXPECT_EQ(world.nearest({cube, at(0)}), (NearestBody{bodies[83], 0}));
    EXPECT_EQ(world.nearest({cube, at(10)}), (NearestBody{bodies[0], 10 - 0.0625 * 99 - 1}));
}

TEST_P(WorldNearestTest, FiltersApply) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(2));
    const BodyId c = world.create_body(cube, at(-3));
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.nearest(a), (NearestBody{c, 2}));
    EXPECT_EQ(world.nearest(b), (NearestBody{c, 4}));
    EXPECT_EQ(closest_pair(), (Near{{a, c}, 2}));
    world.set_filter(c, {.groups = 2});
    EXPECT_EQ(world.nearest({cube, at(-1.5)}), (NearestBody{a, 0.5}));
    EXPECT_EQ(world.nearest({{cube, at(-1.5)}, CollisionFilter{.mask = 2}}), (NearestBody{c, 0.5}));
    EXPECT_EQ(world.nearest({{cube, at(-1.5)}, CollisionFilter{.mask = 4}}), std::nullopt);
}

TEST_P(WorldNearestTest, BadLimitsAreRefused) {
    const BodyId a = world.create_body(cube, at(0));
    for (const double bad : {-1.0, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_INVALID(world.nearest(a, bad), Argument::distance);
        EXPECT_INVALID(world.nearest({cube, at(0)}, bad), Argument::distance);
        EXPECT_INVALID(world.closest_pair(bad), Argument::distance);
    }
    EXPECT_THROW(static_cast<void>(world.nearest(BodyId{})), StaleBody);
    EXPECT_INVALID(world.nearest({std::shared_ptr<const Mesh>(), at(0)}), Argument::null);
    Pose bad = at(0);
    bad.t[1] = infinity;
    EXPECT_INVALID(world.nearest({cube, bad}), Argument::pose);
}

// Against asking all, in scenes of several sizes of bodies, sparse and dense, while bodies move.
TEST_P(WorldNearestTest, IsWhatAskingAllSays) {
    scenes::Random random(11);
    const std::array meshes = {scenes::cube(0.5), scenes::cube(0.0625), scenes::cube(2)};
    const auto any_pose = [&](double extent) {
        return at(random.uniform(-extent, extent), random.uniform(-extent, extent), random.uniform(-extent, extent));
    };
    for (const double extent : {4.0, 12.0}) {
        std::vector<BodyId> bodies;
        for (int i = 0; i < 120; ++i) bodies.push_back(world.create_body(meshes[random.below(3)], any_pose(extent)));
        std::ranges::sort(bodies);
        for (int frame = 0; frame < 4; ++frame) {
            std::optional<Near> closest;
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                std::optional<NearestBody> nearest;
                for (const BodyId other : bodies) {
                    if (other == bodies[i]) continue;
                    const double d = world.distance(bodies[i], other, memory);
                    if (!nearest || d < nearest->distance) nearest = NearestBody{other, d};
                    if (other > bodies[i] && (!closest || d < closest->distance)) {
                        closest = Near{{bodies[i], other}, d};
                    }
                }
                ASSERT_EQ(world.nearest(bodies[i], World::no_limit, memory), nearest);
                ASSERT_EQ(world.nearest(bodies[i], std::nextafter(nearest->distance, infinity)), nearest);
            }
            ASSERT_EQ(closest_pair(), closest);
            for (int i = 0; i < 30; ++i) world.set_pose(bodies[random.below(120)], any_pose(extent));
        }
        for (const BodyId body : bodies) world.destroy_body(body);
    }
}

}  // namespace
}  // namespace ecods::world_nearest_test
