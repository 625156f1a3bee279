// Convex solids in a world: how far two of them are from each other, how deep, and the same of all pairs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_convex_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const ConvexSolid> convex_cube(double half) {
    return std::make_shared<const ConvexSolid>(scenes::cube(half));
}

class WorldConvexTest : public EachWorld {
  protected:
    std::vector<BodyPair> all_pairs() const {
        std::vector<BodyPair> pairs;
        const std::vector<BodyId> bodies = world.bodies();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const bool is_on = may_meet(world.filter(bodies[i]), world.filter(bodies[j])) &&
                                   world.is_pair_enabled(bodies[i], bodies[j]);
                if (is_on) pairs.push_back({bodies[i], bodies[j]});
            }
        }
        return pairs;
    }
    std::shared_ptr<const ConvexSolid> convex(BodyId body) const {
        return std::dynamic_pointer_cast<const ConvexSolid>(world.shape(body));
    }
    bool are_convex(const BodyPair& pair) const { return convex(pair.a) && convex(pair.b); }
    Posed<MeshShape> posed(BodyId body) const {
        return {dynamic_cast<const MeshShape&>(*world.shape(body)), world.pose(body)};
    }
    // Without the world's trees. Of no pair here a limit is between the distance and its rounding.
    std::vector<PairDistance> distances(double limit) {
        std::vector<PairDistance> result;
        for (const BodyPair& pair : all_pairs()) {
            double d = distance(posed(pair.a), posed(pair.b), memory);
            if (d == 0 && are_convex(pair)) {
                const auto a = convex(pair.a), b = convex(pair.b);
                d = signed_distance({*a, world.pose(pair.a)}, {*b, world.pose(pair.b)}, memory).distance;
            }
            if (d <= limit) result.push_back({pair, d});
        }
        return result;
    }
    std::vector<BodyDepth> depths() {
        std::vector<BodyDepth> result;
        for (const PairDistance& pair : distances(0)) {
            if (!are_convex(pair.bodies)) continue;
            const auto a = convex(pair.bodies.a), b = convex(pair.bodies.b);
            result.push_back(
                {pair.bodies, depth({*a, world.pose(pair.bodies.a)}, {*b, world.pose(pair.bodies.b)}, memory).value()});
        }
        return result;
    }

    std::shared_ptr<const ConvexSolid> large = convex_cube(1), small = convex_cube(0.25);
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldConvexTest, broad_phases(), broad_phase_name);

TEST_P(WorldConvexTest, QuestionsAboutAPair) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(3, 0.5, 0.25));
    EXPECT_EQ(world.distance(a, b), 1.75);
    EXPECT_EQ(world.distance(b, a, memory), 1.75);
    const auto points = world.closest(a, b), swapped = world.closest(b, a, memory);
    EXPECT_EQ(points.distance, 1.75);
    EXPECT_EQ(points.point_a[0], 1);
    EXPECT_EQ(points.point_b[0], 2.75);
    EXPECT_EQ(swapped.point_a, points.point_b);
    EXPECT_EQ(swapped.point_b, points.point_a);
    EXPECT_EQ(swapped.a, points.b);
    EXPECT_EQ(swapped.b, points.a);
    EXPECT_FALSE(world.depth(b, a));
    EXPECT_FALSE(world.depth(a, b, memory));
    world.set_pose(b, at(0.75, 0.5, 0.25));
    EXPECT_EQ(world.distance(a, b), 0) << "as of now";
    EXPECT_EQ(world.closest(a, b).kind, ClosestKind::intersecting);
    world.set_pose(b, at(0.5, 0.25, 0));
    EXPECT_EQ(world.closest(a, b).kind, ClosestKind::contained);
    EXPECT_EQ(world.closest(a, b).a, no_feature);
    EXPECT_EQ(world.closest(b, a).b, no_feature);
    EXPECT_EQ(world.closest(a, b).b, world.closest(b, a).a);
    EXPECT_EQ(world.closest(a, b).b, (Feature{Feature::Kind::vertex, 0, 0}));
    world.set_pose(b, at(0.75, 0.5, 0.25));
    const Depth depth = world.depth(a, b).value(), back = world.depth(b, a, memory).value();
    EXPECT_EQ(depth.depth, 0.5);
    EXPECT_EQ(depth.direction, Vec3(1, 0, 0));
    EXPECT_EQ(depth.a.kind, Feature::Kind::face);
    EXPECT_EQ(back.depth, 0.5);
    EXPECT_EQ(back.direction, Vec3(-1, 0, 0));
    EXPECT_FALSE(std::signbit(back.direction[1]) || std::signbit(back.direction[2])) << "a zero is +0";
    EXPECT_EQ(back.a, depth.b);
    EXPECT_EQ(back.b, depth.a);
    const SignedDistance found = world.signed_distance(a, b), turned = world.signed_distance(b, a, memory);
    EXPECT_EQ(found.distance, -0.5);
    EXPECT_EQ(found.direction, depth.direction);
    EXPECT_EQ(turned.distance, -0.5);
    EXPECT_EQ(turned.direction, Vec3(-1, 0, 0));
    EXPECT_EQ(turned.a, found.b);
    EXPECT_EQ(turned.b, found.a);
    EXPECT_EQ(turned.point_a, found.point_b);
    EXPECT_EQ(turned.point_b, found.point_a);
}

// It is the second body given that is parted.
TEST_P(WorldConvexTest, BoundsOfTheDepthOfSolids) {
    const BodyId a = world.create_body(std::make_shared<const Solid>(scenes::cube(1)), at(0));
    const BodyId b = world.create_body(small, at(0.75, 0.5, 0.25)), c = world.create_body(scenes::cube(1), at(0));
    for (const auto& [fixed, moved] : {std::pair(a, b), {b, a}}) {
        const DepthBounds bounds = world.depth_bounds(fixed, moved).value();
        EXPECT_GT(bounds.lower, 0);
        EXPECT_LE(bounds.lower, 0.5);
        EXPECT_GE(bounds.upper, 0.5);
        const Pose before = world.pose(moved);
        world.set_pose(moved, {before.R, bounds.parted});
        EXPECT_NE(world.relation(a, b), Relation::overlapping);
        EXPECT_LE((bounds.parted - before.t).norm(), bounds.upper);
        world.set_pose(moved, before);
    }
    EXPECT_THROW(static_cast<void>(world.depth_bounds(a, c)), NotSupported);
    EXPECT_THROW(static_cast<void>(world.depth_bounds(a, a)), SameBody);
    world.set_pose(b, at(9));
    EXPECT_FALSE(world.depth_bounds(b, a, memory));
    EXPECT_FALSE(world.depth_bounds(a, b));
}

// Of several ways out as short as each other the world takes that of the lesser id's first face, whoever is asked
// first.
TEST_P(WorldConvexTest, TiesAreThoseOfTheLesserId) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0));
    const Depth expected = ecods::depth({*large, at(0)}, {*small, at(0)}, memory).value();
    EXPECT_EQ(expected.depth, 1.25);
    EXPECT_EQ(world.depth(a, b), expected);
    Depth back = world.depth(b, a).value();
    EXPECT_EQ(back.direction, Vec3(Vec3::Zero() - expected.direction));
    std::swap(back.a, back.b);
    back.direction = expected.direction;
    EXPECT_EQ(back, expected);
}

TEST_P(WorldConvexTest, BodiesThatAreNoConvexSolids) {
    const BodyId convex = world.create_body(large, at(0));
    const BodyId solid = world.create_body(std::make_shared<const Solid>(scenes::cube(1)), at(0));
    const BodyId surface = world.create_body(scenes::cube(1), at(0));
    for (const BodyId other : {solid, surface}) {
        EXPECT_EQ(world.distance(convex, other), 0);
        EXPECT_EQ(world.closest(other, convex).kind, ClosestKind::intersecting);
        EXPECT_THROW(static_cast<void>(world.depth(other, convex)), NotSupported);
    }
    EXPECT_THROW(static_cast<void>(world.depth(convex, convex)), SameBody);
    EXPECT_THROW(static_cast<void>(world.distance(convex, BodyId{})), StaleBody);
    EXPECT_TRUE(world.depths().empty());
    EXPECT_EQ(world.signed_distances(infinity), distances(infinity)) << "all kinds of bodies";
    world.set_shape(solid, large);
    EXPECT_EQ(world.depths().size(), 1u);
    world.destroy_body(solid);
    EXPECT_TRUE(world.depths(memory).empty());
}

TEST_P(WorldConvexTest, SingularPosesAreNamed) {
    Pose flat = at(100);
    flat.R.col(1) = flat.R.col(0);
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, flat);
    const auto require_named = [&](auto ask) {
        try {
            ask();
            ADD_FAILURE();
        } catch (const SingularPose& error) {
            EXPECT_EQ(error.body, b);
        }
    };
    EXPECT_EQ(world.distance(a, b), 98.5) << "of a flat image";
    EXPECT_EQ(world.closest(b, a).distance, 98.5);
    require_named([&] { std::ignore = world.depth(a, b); });
    require_named([&] { std::ignore = world.depths(); });  // however far
    EXPECT_EQ(world.signed_distances(100), (std::vector<PairDistance>{{{a, b}, 98.5}}));
    world.set_shape(b, std::make_shared<const Solid>(scenes::cube(1)));
    EXPECT_TRUE(world.depths().empty());
}

// The cubes' corners are apart by 1 on two axes, or on three: of the two roots one rounds up and the other down.
TEST_P(WorldConvexTest, LimitsAreDecidedForTheRealDistance) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(large, at(3, 3, 0));
    const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0);
    EXPECT_EQ(world.signed_distances(root2), (std::vector<PairDistance>{{{a, b}, root2}}));
    EXPECT_TRUE(world.signed_distances(std::nextafter(root2, 0)).empty());
    world.set_pose(b, at(3, 3, 3));
    EXPECT_TRUE(world.signed_distances(root3).empty()) << "which is less than the root of 3, and nearest to it";
    EXPECT_EQ(world.signed_distances(std::nextafter(root3, 2)), (std::vector<PairDistance>{{{a, b}, root3}}));
    world.set_pose(b, at(1.75));
    EXPECT_EQ(world.signed_distances(0), (std::vector<PairDistance>{{{a, b}, -0.25}}));
    world.set_pose(b, at(2));
    EXPECT_EQ(world.signed_distances(0), (std::vector<PairDistance>{{{a, b}, 0}}));
    EXPECT_EQ(world.signed_distances(-0.0).size(), 1u);
    EXPECT_EQ(world.depths().size(), 1u) << "they touch";
    EXPECT_EQ(world.depths()[0].depth.depth, 0);
    EXPECT_INVALID(world.signed_distances(-1), Argument::distance);
    EXPECT_INVALID(world.signed_distances(std::nan("")), Argument::distance);
    EXPECT_INVALID(world.signed_distances(-infinity, memory), Argument::distance);
}

// Turned bodies, and boxes on a lattice that tie and touch; some are no convex solids, and pairs are filtered out.
TEST_P(WorldConvexTest, ListsAreThoseOfAllPairsOneByOne) {
    scenes::Random random(3);
    const auto sphere = std::make_shared<const ConvexSolid>(scenes::sphere(7, 5)->vertices());
    const auto coordinate = [&] { return 0.5 * (static_cast<double>(random.below(15)) - 7); };
    std::vector<BodyId> bodies;
    std::size_t depth_count = 0, distance_count = 0;
    for (int frame = 0; frame < 12; ++frame) {
        const std::size_t count = frame < 6 ? 20 : 90;  // above 64, trees are used
        while (bodies.size() < count) {
            const Pose pose = at(coordinate(), coordinate(), coordinate());
            const std::uint32_t what = random.below(8);
            bodies.push_back(what == 0   ? world.create_body(scenes::cube(1), pose)
                             : what == 1 ? world.create_body(std::make_shared<const Solid>(scenes::cube(1)), pose)
                             : what < 4  ? world.create_body(sphere, pose)
                             : what < 6  ? world.create_body(large, pose)
                                         : world.create_body(small, pose));
        }
        for (int change = 0; change < 10; ++change) {
            const auto pick = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
            Pose pose = at(coordinate(), coordinate(), coordinate());
            if (random.below(2) == 0) pose.R = random.rotation().toRotationMatrix();
            world.set_pose(pick(), pose);
            const BodyId x = pick(), y = pick();
            if (change == 0) world.set_filter(x, {.groups = random.below(2) + 1, .mask = 3});
            if (change == 1) world.set_filter(x, {.groups = 1, .mask = random.below(2) + 1});
            if (change == 2 && x != y) world.set_pair_enabled(x, y, false);
        }
        if (frame % 3 == 0) world.update();  // or not: they are as of now
        EXPECT_EQ(world.depths(), depths());
        const std::vector<PairDistance> all = distances(infinity);
        const auto up_to = [&](double limit) {
            std::vector<PairDistance> some = all;
            std::erase_if(some, [&](const PairDistance& pair) { return pair.distance > limit; });
            return some;
        };
        for (const double limit : {0.0, 0.5, 1.25}) EXPECT_EQ(world.signed_distances(limit), up_to(limit)) << limit;
        EXPECT_EQ(world.signed_distances(infinity, memory), all);
        // Just below one of them, which is then no more there.
        const double below = std::nextafter(all[all.size() / 2].distance, -infinity);
        if (below >= 0) {
            EXPECT_EQ(world.signed_distances(below), up_to(below));
        }
        depth_count += world.depths(memory).size();
        distance_count += world.signed_distances(1.25).size();
    }
    EXPECT_GT(depth_count, 100u);
    EXPECT_GT(distance_count, 2 * depth_count);
}

TEST_P(WorldConvexTest, TracesHaveConvexSolidsAndTheirQuestions) {
    std::ostringstream out;
    world.trace_to(out, {.questions = true});
    world.create_body(large, at(0));
    const BodyId b = world.create_body(small, at(1));
    world.update();
    std::ignore = world.depths();
    std::ignore = world.signed_distances(2);
    world.set_pose(b, at(2));
    std::ignore = world.signed_distances(infinity);
    std::ignore = world.depths(memory);
    world.end_trace();
    EXPECT_NE(out.str().find("\nconvex 1 8 12\n"), std::string::npos) << out.str();
    std::istringstream in(out.str());
    const ReplayReport report = replay(in, {.broad_phase = GetParam()});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.question_count, 3u) << "those without a memory of the caller's";

    // With a Solid in its place there is no pair of convex solids.
    std::string other = out.str();
    other.replace(other.find("\nconvex 1 "), 10, "\nsolid 1 ");
    std::istringstream changed(other);
    EXPECT_TRUE(replay(changed, {.broad_phase = GetParam()}).difference.has_value());
}

}  // namespace
}  // namespace ecods::world_convex_test
