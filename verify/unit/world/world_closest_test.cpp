// The closest pairs of bodies: known answers, limits, groups, and hints that are out of date.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_closest_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t everything = ~std::uint64_t{0};

using ShapePtr = std::shared_ptr<const Shape>;

// Two bodies and their distance.
struct Near {
    BodyPair bodies;
    double distance;
};

bool is_first(const Near& x, const Near& y) {
    return std::pair(x.distance, x.bodies) < std::pair(y.distance, y.bodies);
}

class WorldClosest : public EachWorld {
  protected:
    BodyId create(const ShapePtr& shape, const Pose& pose, std::uint64_t groups = 1) {
        return world.create_body({.shape = shape, .pose = pose, .filter = {.groups = groups}});
    }
    std::shared_ptr<const ConvexSolid> box = std::make_shared<ConvexSolid>(scenes::cube(0.5));
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldClosest, broad_phases(), broad_phase_name);

TEST_P(WorldClosest, OfAnEmptyWorldAndOfOneBody) {
    EXPECT_EQ(world.closest_pair(infinity, 1, 1), std::nullopt);
    EXPECT_TRUE(world.closest_pairs(infinity).empty());
    create(box, at(0), 3);
    EXPECT_EQ(world.closest_pair(infinity, 1, 2), std::nullopt) << "a body is no pair";
    EXPECT_TRUE(world.closest_pairs(infinity, 1, 2).empty());
    create(box, at(5), 4);
    EXPECT_TRUE(world.closest_pairs(infinity, 1, 2).empty());
    EXPECT_EQ(world.closest_pair(infinity, 1, 2), std::nullopt);
    EXPECT_TRUE(world.closest_pairs(infinity, 0, everything).empty());
    EXPECT_EQ(world.closest_pairs(infinity, 4, 2).size(), 1u);
}

TEST_P(WorldClosest, TheDeepestPairComesFirst) {
    const BodyId a = create(box, at(0)), b = create(box, at(0.75)), c = create(box, at(0, 0.5)), d = create(box, at(3));
    const std::vector<ClosestPair> pairs = world.closest_pairs(1.5, memory);
    ASSERT_EQ(pairs.size(), 4u);
    EXPECT_EQ(pairs[0].bodies, (BodyPair{a, c}));
    EXPECT_EQ(pairs[0].distance, -0.5);
    EXPECT_EQ(pairs[0].direction, Vec3(0, 1, 0));
    EXPECT_EQ(pairs[0].points->point_a[1] - pairs[0].points->point_b[1], 0.5);
    EXPECT_EQ(pairs[1].bodies, (BodyPair{a, b}));
    EXPECT_EQ(pairs[1].distance, -0.25);
    EXPECT_EQ(pairs[2].bodies, (BodyPair{b, c}));
    EXPECT_EQ(pairs[2].distance, -0.25) << "of equal ones, the lesser pair is first";
    EXPECT_EQ(pairs[3].bodies, (BodyPair{b, d}));
    EXPECT_EQ(pairs[3].distance, 1.25);
    EXPECT_FALSE(pairs[3].direction);
    EXPECT_EQ(world.closest_pair(infinity, memory), pairs[0]);
    EXPECT_EQ(world.closest_pair(0), pairs[0]);
    EXPECT_EQ(world.closest_pairs(1.25).size(), 4u);
    EXPECT_EQ(world.closest_pairs(std::nextafter(1.25, 0)).size(), 3u);
    EXPECT_EQ(world.closest_pairs(-0.0).size(), 3u);
}

// The root of 3 is above the double nearest to it.
TEST_P(WorldClosest, TheLimitIsForTheRealDistance) {
    create(box, at(0), 1);
    create(box, at(2, 2, 2), 2);
    const double root = world.closest_pair()->distance;
    EXPECT_EQ(root, std::sqrt(3.0));
    EXPECT_EQ(world.closest_pair(root, 1, 2), std::nullopt);
    EXPECT_TRUE(world.closest_pairs(root, 2, 1).empty());
    EXPECT_EQ(world.closest_pairs(std::nextafter(root, 2), 2, 1).size(), 1u);
    EXPECT_EQ(world.closest_pair(std::nextafter(root, 2), 2, 1)->distance, root);
    for (const double bad : {-1.0, -infinity, std::nan("")}) {
        EXPECT_INVALID(world.closest_pairs(bad), Argument::distance);
        EXPECT_INVALID(world.closest_pairs(bad, 1, 2, memory), Argument::distance);
        EXPECT_INVALID(world.closest_pair(bad, 1, 2), Argument::distance);
    }
}

// A hint says that they are closest; then one of them is gone, and another body is in its place.
TEST_P(WorldClosest, TheLastWinnerMayBeGoneSwitchedOffOrOfAnotherGroup) {
    const BodyId arm = create(box, at(0), 1), near = create(box, at(2), 2), far = create(box, at(4), 2);
    const auto closest = [&] { return world.closest_pair(infinity, 1, 2, memory)->bodies; };
    EXPECT_EQ(closest(), (BodyPair{arm, near}));
    world.set_pair_enabled(arm, near, false);
    EXPECT_EQ(closest(), (BodyPair{arm, far}));
    world.set_pair_enabled(arm, near, true);
    EXPECT_EQ(closest(), (BodyPair{arm, near}));
    world.set_filter(near, {.groups = 4});
    EXPECT_EQ(closest(), (BodyPair{arm, far}));
    world.set_filter(near, {.groups = 2});
    EXPECT_EQ(closest(), (BodyPair{arm, near}));
    world.destroy_body(near);
    EXPECT_EQ(closest(), (BodyPair{arm, far}));
    const BodyId other = create(box, at(0, 9), 2);
    EXPECT_EQ(other.slot, near.slot);
    EXPECT_EQ(closest(), (BodyPair{arm, far}));
    world.set_filter(arm, {.groups = 1, .mask = 0});
    EXPECT_EQ(world.closest_pair(infinity, 1, 2, memory), std::nullopt);
    EXPECT_TRUE(world.closest_pairs(infinity, 1, 2, memory).empty());
}

// So many that their boxes are looked up in trees.
TEST_P(WorldClosest, OfManyBodies) {
    scenes::Random random(5);
    std::vector<BodyId> ids;
    for (int i = 0; i < 200; ++i) {
        ids.push_back(create(box, at(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)), 1 + i % 3));
    }
    for (int frame = 0; frame < 4; ++frame) {
        std::optional<Near> least;
        for (const BodyId a : ids) {
            for (const BodyId b : ids) {
                const std::uint64_t x = world.filter(a).groups, y = world.filter(b).groups;
                if (!(a < b) || !(((x & 1) != 0 && (y & 2) != 0) || ((x & 2) != 0 && (y & 1) != 0))) continue;
                if ((world.pose(a).t - world.pose(b).t).norm() > 2.5) continue;
                const Near pair{{a, b}, world.signed_distance(a, b).distance};
                if (!least || is_first(pair, *least)) least = pair;
            }
        }
        ASSERT_TRUE(least);
        const auto found = world.closest_pair(infinity, 1, 2, memory);
        EXPECT_EQ(found->bodies, least->bodies);
        EXPECT_EQ(found->distance, least->distance);
        EXPECT_EQ(world.closest_pair(infinity, 2, 1), found);
        EXPECT_EQ(world.closest_pairs(found->distance > 0 ? 2 * found->distance : 0.25, 2, 1).front(), *found);
        world.destroy_body(found->bodies.a);
        std::erase(ids, found->bodies.a);
    }
}

TEST_P(WorldClosest, ASolidAtASingularPoseIsFlat) {
    Pose flat = at(0);
    flat.R(2, 2) = 0;
    const BodyId a = create(box, flat), b = create(box, at(0, 0, 0.25));
    EXPECT_EQ(world.closest_pair(), world.closest_pairs(0).front());
    EXPECT_EQ(world.closest_pair()->bodies, (BodyPair{a, b}));
    EXPECT_EQ(world.closest_pair()->distance, 0) << "it has no inside";
    world.set_pose(b, at(0, 0, 2));
    EXPECT_EQ(world.closest_pair()->distance, 1.5);
}

TEST_P(WorldClosest, TwoHalfSpacesHaveNoPoints) {
    const BodyId floor = create(std::make_shared<HalfSpace>(Vec3(0, 0, 2), 0), at(0), 1);
    const BodyId ceiling = create(std::make_shared<HalfSpace>(Vec3(0, 0, -1), -3), at(0), 1);
    const BodyId ball = create(sphere(1), at(0, 0, 2), 2);
    const std::vector<ClosestPair> pairs = world.closest_pairs(infinity);
    ASSERT_EQ(pairs.size(), 3u);
    EXPECT_EQ(pairs[0].bodies, (BodyPair{ceiling, ball}));
    EXPECT_EQ(pairs[0].distance, 0);
    EXPECT_TRUE(pairs[0].points && pairs[0].direction);
    EXPECT_EQ(pairs[1].bodies, (BodyPair{floor, ball}));
    EXPECT_EQ(pairs[1].distance, 1);
    EXPECT_EQ(pairs[2].bodies, (BodyPair{floor, ceiling}));
    EXPECT_EQ(pairs[2].distance, 3);
    EXPECT_FALSE(pairs[2].points || pairs[2].direction);
    EXPECT_EQ(world.closest_pair(infinity, 1, 1), pairs[2]);
}

// A trace holds the questions, with groups in hexadecimal; a replay compares the answers.
TEST_P(WorldClosest, TracesHoldTheQuestions) {
    std::ostringstream out;
    create(box, at(0), 0x10);
    create(box, at(0.5), 0x20);
    world.trace_to(out, {.questions = true});
    std::ignore = world.closest_pair(infinity, 0x10, 0x20);
    std::ignore = world.closest_pairs(0.25, 0x20, 0x10);
    std::ignore = world.closest_pairs(0.25);
    world.end_trace();
    EXPECT_NE(out.str().find(" inf 10 20\n"), std::string::npos) << out.str();
    std::istringstream in(out.str());
    const ReplayReport report = replay(in);
    EXPECT_FALSE(report.difference);
    EXPECT_EQ(report.question_count, 3u);
}

}  // namespace
}  // namespace ecods::world_closest_test
