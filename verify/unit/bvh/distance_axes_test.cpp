// No bound of a distance is above the distance, however hard it is tried; most are not far below.

#include "bvh/axes/distance_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <string>

#include "bvh/masks/triangle_bounds.hpp"
#include "bvh/walks/nearest_queue.hpp"
#include "scenes/distance_cases.hpp"
#include "unit/bvh/tree_body.hpp"

namespace ecods::distance_axes_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Two bodies, their bounds in the rounding mode that is set, and what is true.
struct Pair {
    Body a, b;
    oracle::MeshDistances truth;
    DistanceAxes axes;
    Direction direction{};

    explicit Pair(const scenes::DistanceCase& c) : a(c.a, c.pose_a), b(c.b, c.pose_b), truth(a.soup(), b.soup()) {}

    void bind() { axes.bind(a.posed(), b.posed(), b.pose.t - a.pose.t); }
};

// near_mask() of every instruction set.
template <class X, class Y>
std::uint64_t near_mask_of(const Pair& pair, float limit, const X& x, const Y& y, LaneBounds& squares) {
    return mask_of_all(squares, [&](LaneBounds& numbers) {
        return near_mask(pair.axes.sets(), pair.direction, limit, x, y, numbers);
    });
}

// Whether the trees let triangles i and j through to the leaves, from the roots down, where nothing beyond the limit
// matters.
bool let_through(const Pair& pair, float limit, std::uint32_t i, std::uint32_t j) {
    alignas(32) LaneBounds squares;
    const auto mask = [&](const auto& x, const auto& y) { return near_mask_of(pair, limit, x, y, squares); };
    return let_through(pair.a, pair.b, mask, i, j);
}

// Bounds of all triangles of two leaves, whose distances are between them.
struct Tally {
    std::uint64_t apart = 0, boxes = 0, triangles = 0;
};

void check_leaves(const Pair& pair, const TreeLeaf& x, const TreeLeaf& y, Tally& tally) {
    alignas(32) LaneBounds squares;
    const std::uint64_t mask = near_mask_of(pair, infinity, x, y, squares);
    LeavesOnAxes leaves;
    put_on_axes(pair.axes.sets()[0], x, y, leaves);
    for (std::size_t i = 0; i < x.count; ++i) {
        for (std::size_t j = 0; j < y.count; ++j) {
            ASSERT_TRUE(mask >> (tree_width * j + i) & 1) << "beyond infinity";
            TriangleBatch batch{};
            batch.add(leaves, i, j, {x.triangle[i], y.triangle[j]});
            TriangleSquares bounds;
            bound_triangles(pair.axes.sets()[0], batch, bounds);
            const double box = pair.axes.distance_below(squares[tree_width * i + j]);
            const double lower = pair.axes.distance_below(bounds.lower[0]);
            const double upper = pair.axes.distance_above(bounds.upper[0]);
            const int mode = std::fegetround();
            std::fesetround(FE_TONEAREST);
            const oracle::ExactRoot exact = pair.truth.distance(x.triangle[i], y.triangle[j]);
            EXPECT_GE(compare(exact, box), 0)
                << "box " << box << " of " << nearest(exact) << ", rounding mode " << mode;
            EXPECT_GE(compare(exact, lower), 0)
                << "lower " << lower << " of " << nearest(exact) << ", rounding mode " << mode;
            EXPECT_LE(compare(exact, upper), 0)
                << "upper " << upper << " of " << nearest(exact) << ", rounding mode " << mode;
            const double d = nearest(exact);
            tally.apart += d > 0;
            tally.boxes += box > 0.5 * d;
            tally.triangles += lower > 0.9 * d && upper < 1.1 * d;
            std::fesetround(mode);
        }
    }
}

void bend(Pose& pose, double amount, scenes::Random& random) {
    Mat3 by = Mat3::Identity();
    for (int i = 0; i < 9; ++i) by.data()[i] += amount * random.uniform(-1, 1);
    pose.R = pose.R * by;
}

class DistanceBoundsTest : public testing::TestWithParam<scenes::Family<scenes::DistanceCase>> {};

TEST_P(DistanceBoundsTest, AreBounds) {
    scenes::Random random(11);
    Tally tally;
    constexpr std::size_t pair_count = 2000;
    for (std::size_t k = 0, pairs = 0; pairs < pair_count; ++k) {
        scenes::DistanceCase c = GetParam().make(random);
        // Rotations that are off by a little, and by so much that axes of the world are better.
        if (k % 4 == 3) bend(c.pose_a, std::exp2(random.uniform(-20, -5)), random);
        Pair pair(c);
        pairs += pair.a.mesh->triangles().size() * pair.b.mesh->triangles().size() + 5;
        const oracle::ExactClosest closest = pair.truth.closest();
        const double d = nearest(closest.distance);
        for (int axis = 0; axis < 3; ++axis) {
            pair.direction[static_cast<std::size_t>(axis)] = static_cast<float>(random.uniform(-0.57, 0.57));
        }
        for (const int mode : rounding_modes) {
            std::fesetround(mode);
            pair.bind();
            // The nearest pair is within its distance, at once and from the least limit on that says so.
            const float limit = pair.axes.square_above(d);
            EXPECT_TRUE(let_through(pair, limit, closest.a.triangle, closest.b.triangle)) << "rounding mode " << mode;
            for (const TreeLeaf& x : pair.a.tree.leaves) {
                for (const TreeLeaf& y : pair.b.tree.leaves) check_leaves(pair, x, y, tally);
            }
        }
        std::fesetround(FE_TONEAREST);
        if (HasFailure()) FAIL() << "case " << k;
    }
    if (GetParam().name != "apart") return;
    EXPECT_GT(tally.boxes, tally.apart / 2) << "the test would be right if nothing were bounded";
    EXPECT_GT(tally.triangles, tally.apart * 9 / 10);
}

std::string test_name(const testing::TestParamInfo<scenes::Family<scenes::DistanceCase>>& family) {
    std::string text(family.param.name);
    std::ranges::replace_if(
        text, [](char c) { return c == ' ' || c == '-'; }, '_');
    return text;
}

INSTANTIATE_TEST_SUITE_P(Families, DistanceBoundsTest,
                         testing::ValuesIn(scenes::distance_families().begin(), scenes::distance_families().end()),
                         test_name);

TEST(NearestQueue, GivesEachPairOnceAndTheNearestFirst) {
    scenes::Random random(3);
    NearestQueue queue;
    for (int round = 0; round < 20; ++round) {
        const float start = std::exp2(static_cast<float>(random.uniform(-40, 40)));
        queue.start(start);
        std::vector<float> pushed, popped;
        for (int k = 0; k < 500; ++k) {
            const auto share = static_cast<float>(random.uniform(0, 1));
            const float square = k % 50 == 0 ? 0 : start * std::exp2(-30 * share * share);
            queue.push({square, {TreeRef::node(static_cast<std::size_t>(k)), TreeRef::leaf(0)}});
            pushed.push_back(square);
        }
        const float limit = 0.5f * start;
        NearPair pair;
        while (queue.pop(limit, pair)) {
            EXPECT_EQ(pair.square, pushed[pair.nodes.a.index()]);
            // Of pairs that are one part in 32 from each other in square, the nearer one comes first.
            EXPECT_GE(pair.square * (1 + 0x1p-5f), popped.empty() ? 0 : popped.back());
            popped.push_back(pair.square);
        }
        std::erase_if(pushed, [&](float square) { return square > limit; });
        std::ranges::sort(pushed);
        std::ranges::sort(popped);
        EXPECT_EQ(popped, pushed);
    }
}

}  // namespace
}  // namespace ecods::distance_axes_test
