// Questions about what is no body.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_find_test {
namespace {

using Bodies = std::vector<BodyId>;

class WorldFindTest : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldFindTest, broad_phases(), broad_phase_name);

TEST_P(WorldFindTest, BoxesAreAskedAsOfNow) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(2)),
                 c = world.create_body(cube, at(4));
    const Aabb box{Vec3(0.25, -9, -9), Vec3(2, 9, 9)};
    EXPECT_EQ(world.overlapping_bodies(box), (Bodies{a, b})) << "no update is needed";
    EXPECT_EQ(world.overlapping_bodies({Vec3(0.5, 0.5, 0.5), Vec3(0.5, 0.5, 0.5)}), (Bodies{a})) << "closed";
    world.set_pose(c, at(1));
    world.destroy_body(a);
    EXPECT_EQ(world.overlapping_bodies(box), (Bodies{b, c}));
    EXPECT_TRUE(world.overlapping_bodies({Vec3(50, 0, 0), Vec3(51, 1, 1)}).empty());
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(world.overlapping_bodies({Vec3::Constant(-infinity), Vec3::Constant(infinity)}), (Bodies{b, c}));
}

TEST_P(WorldFindTest, ABoxThatIsNoneIsAnError) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_INVALID(world.overlapping_bodies({Vec3(0, 0, 1), Vec3(1, 1, 0)}), Argument::box);
    try {
        std::ignore = world.overlapping_bodies({Vec3(0, nan, 0), Vec3(1, 1, 1)});
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::box);
        EXPECT_EQ(error.part, "min(1)");
        EXPECT_TRUE(std::isnan(error.value));
        EXPECT_EQ(std::string(error.what()), "the box given has [nan, 1] on axis 1");
    }
}

TEST_P(WorldFindTest, TouchingIsExact) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(std::nextafter(2.0, 3.0)));
    EXPECT_EQ(world.intersecting_bodies({cube, at(1)}), (Bodies{a})) << "b is one step of the last place away";
    EXPECT_EQ(world.intersecting_bodies({cube, at(1.125)}), (Bodies{b}));
    EXPECT_EQ(world.intersecting_bodies({MeshShape(scenes::cube(3)), at(0)}), Bodies()) << "inside is not touching";
    EXPECT_EQ(world.intersecting_bodies({MeshShape(cube), at(1, 1, 1)}), (Bodies{a}));
    world.destroy_body(a);
    EXPECT_EQ(world.intersecting_bodies({cube, at(1)}), Bodies());
    world.update();
    world.check_invariants();
}

TEST_P(WorldFindTest, AFilterIsAskedFirst) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.5));
    world.set_filter(a, {.groups = 2});
    const CollisionFilter second{.groups = 1, .mask = 2};
    QueryCounts counts;
    EXPECT_EQ(world.intersecting_bodies({{cube, at(0.25)}, second}, counts), (Bodies{a}));
    EXPECT_EQ(counts.queries, 1u) << "b was not tested";
    EXPECT_EQ(world.intersecting_bodies({cube, at(0.25)}), (Bodies{a, b}));
}

// Each must be in a group that the other's mask names: here one of the two is not.
TEST_P(WorldFindTest, AFilterIsAskedInBothDirections) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.5));
    world.set_filter(a, {.groups = 2, .mask = 4});
    world.set_filter(b, {.groups = 4, .mask = 1});
    const CollisionFilter meets_a_only_one_way{.groups = 1, .mask = 2};
    const CollisionFilter is_met_by_b_only_one_way{.groups = 1, .mask = 3};
    const CollisionFilter meets_b{.groups = 1, .mask = 4};
    EXPECT_EQ(world.intersecting_bodies({{cube, at(0.25)}, meets_a_only_one_way}), Bodies{});
    EXPECT_EQ(world.intersecting_bodies({{cube, at(0.25)}, is_met_by_b_only_one_way}), Bodies{});
    EXPECT_EQ(world.intersecting_bodies({{cube, at(0.25)}, meets_b}), (Bodies{b}));
}

TEST_P(WorldFindTest, TheAnswersAreThoseOfABodyThere) {
    scenes::Random random(5);
    for (int i = 0; i < 60; ++i) {
        world.create_body(cube, at(random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4)));
    }
    for (int i = 0; i < 20; ++i) {
        const Pose pose = at(random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4));
        const Bodies touching = world.intersecting_bodies({cube, pose});
        const Bodies in_box = world.overlapping_bodies(box_of(*cube, pose));
        const BodyId there = world.create_body(cube, pose);
        world.update();
        Bodies expected, candidates;
        for (const BodyPair& pair : world.colliding_pairs()) {
            if (pair.b == there || pair.a == there) expected.push_back(pair.a == there ? pair.b : pair.a);
        }
        for (const BodyPair& pair : world.overlapping_pairs()) {
            if (pair.b == there || pair.a == there) candidates.push_back(pair.a == there ? pair.b : pair.a);
        }
        EXPECT_EQ(touching, expected);
        EXPECT_EQ(in_box, candidates);
        world.destroy_body(there);
    }
}

TEST_P(WorldFindTest, BadArguments) {
    class Other final : public Shape {
      public:
        explicit Other(ShapeKind kind) : kind_(kind) {}
        ShapeKind kind() const noexcept override { return kind_; }
        Aabb box(const Pose&) const override { return {}; }
        std::uint64_t digest() const noexcept override { return 0; }

      private:
        ShapeKind kind_;
    };
    world.create_body(cube, at(0));
    EXPECT_INVALID(world.intersecting_bodies({std::shared_ptr<const Mesh>(), at(0)}), Argument::null);
    EXPECT_INVALID(world.intersecting_bodies({cube, at(std::numeric_limits<double>::infinity())}), Argument::pose);
    EXPECT_INVALID(world.intersecting_bodies({Other({5}), at(0)}), Question::intersects);
    EXPECT_THROW(static_cast<void>(world.intersecting_bodies({Other(ShapeKind::mesh()), at(0)})), NotSupported);
}

}  // namespace
}  // namespace ecods::world_find_test
