// The boxes of a body that turns contain it: what pose_at() says about where its corners are.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "ecods/turn.hpp"
#include "environment/each_environment.hpp"
#include "query/cast/turn_boxes.hpp"
#include "scenes/random.hpp"

namespace ecods::turn_boxes_test {
namespace {

bool contains(const Aabb& box, const Vec3& p) {
    return (box.min.array() <= p.array()).all() && (p.array() <= box.max.array()).all();
}

double size_of(const Aabb& box) {
    return (box.max - box.min).maxCoeff();
}

Vec3 corner(const Aabb& box, std::uint32_t i) {
    return {i % 2 == 0 ? box.min[0] : box.max[0], i / 2 % 2 == 0 ? box.min[1] : box.max[1],
            i / 4 == 0 ? box.min[2] : box.max[2]};
}

// A piece of a turn, which begins at time `from`.
struct Piece {
    double from;
    Aabb box;
};
struct Boxes {
    std::vector<Piece> pieces;
    Aabb whole;
};

// Divides long pieces, but for some, up to the time `latest`.
Boxes boxes_of(const Aabb& start, const Turn& turn, double latest, std::uint32_t seed) {
    scenes::Random random(seed);
    const TurnBoxes boxes(start, turn);
    Boxes result{{}, boxes.whole()};
    boxes.visit(latest, [&](double from, const Aabb& box, bool may_divide) {
        if (may_divide && random.below(8) != 0) return TurnBoxes::Next::divide;
        result.pieces.push_back({from, box});
        return TurnBoxes::Next::go_on;
    });
    return result;
}

Turn any_turn(scenes::Random& random, double unit) {
    const auto part = [&] { return random.uniform(-1, 1); };
    Turn turn{{part(), part(), part(), part()}, Vec3::Zero(), Vec3::Zero()};
    switch (random.below(6)) {
        case 0:
            turn.q = {1, 0, 0, 0};
            break;
        case 1:
            turn.q = {-1, 0, 0x1p-20, 0};
            break;
        case 2:
            turn.q = {1, 0x1p-30 * part(), 0, 0};
            break;
        case 3:
            turn.q = {0.5, 0, 0, 1};
            break;
        default:
            break;
    }
    for (int k = 0; k < 3; ++k) turn.pivot_from[k] = turn.pivot_to[k] = unit * random.uniform(-4, 4);
    if (random.below(2) == 0) turn.pivot_to += unit * Vec3(part(), part(), 4 * part());
    if (random.below(6) == 0) turn.pivot_to = turn.pivot_from += Vec3::Constant(unit * 0x1p40);
    return turn;
}

// In every environment, for bodies of all sizes. A place rounds to a number that is in the box if the place is, as the
// ends of the box are doubles.
TEST(TurnBoxes, ContainTheBody) {
    scenes::Random random(5);
    std::size_t bounded = 0, pieces = 0;
    for (std::uint32_t round = 0; round < 150; ++round) {
        const double unit = std::ldexp(1.0, std::array{-1060, -600, -40, 0, 0, 0, 300, 700}[random.below(8)]);
        Aabb start{Vec3::Zero(), Vec3::Zero()};
        for (int k = 0; k < 3; ++k) {
            start.min[k] = unit * random.uniform(-2, 1);
            start.max[k] = start.min[k] + unit * random.uniform(0, 1);
        }
        const Turn turn = any_turn(random, unit);
        const double latest = random.below(3) == 0 ? random.uniform(0, 1) : 1;
        const auto expect_inside = [&](const Aabb& box, double time, const std::string& where) {
            const Vec3 place = pose_at({Mat3::Identity(), corner(start, random.below(8))}, turn, time).t;
            ASSERT_TRUE(contains(box, place)) << round << ", " << time << ", " << where;
        };
        const auto look = [&](const Boxes& boxes, const std::string& where) {
            pieces += boxes.pieces.size();
            for (int sample = 0; sample < 6; ++sample) {
                const std::size_t i = random.below(static_cast<std::uint32_t>(boxes.pieces.size()));
                const double from = boxes.pieces[i].from;
                const double to = i + 1 < boxes.pieces.size() ? boxes.pieces[i + 1].from : latest;
                ASSERT_LE(from, to);
                const double time = from + 0.25 * random.below(5) * (to - from);
                expect_inside(boxes.pieces[i].box, time, where);
                expect_inside(boxes.whole, time, where);
                bounded += std::isfinite(size_of(boxes.pieces[i].box));
            }
        };
        environment::in_each_environment([&] { return boxes_of(start, turn, latest, round); }, look);
    }
    EXPECT_GT(bounded, 5000u);
    EXPECT_GT(pieces, 5000u);
}

// A bar that turns by a quarter, and a body that only glides.
TEST(TurnBoxes, AreTight) {
    const Aabb bar{{0, -0.125, -0.125}, {4, 0.125, 0.125}};
    const Aabb box = TurnBoxes(bar, about({0, 0, 1}, std::numbers::pi / 2, Vec3::Zero())).whole();
    EXPECT_GT(box.min[0], -0.5);
    EXPECT_LT(box.max[0], 4.5);
    EXPECT_GT(box.min[1], -0.5);
    EXPECT_LT(box.max[1], 4.5);
    EXPECT_NEAR(box.min[2], -0.125, 0x1p-40);
    EXPECT_NEAR(box.max[2], 0.125, 0x1p-40);
    const Aabb glide = TurnBoxes(bar, {{}, {7, 7, 7}, {9, 7, 3}}).whole();
    EXPECT_NEAR(glide.max[0], 6, 0x1p-40);
    EXPECT_NEAR(glide.max[1], 0.125, 0x1p-40);
    EXPECT_NEAR(glide.min[2], -4.125, 0x1p-40);
    const TurnBoxes point({{5, 0, 0}, {5, 0, 0}}, {{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()});
    EXPECT_LT(point.whole().max[0], 5.01);
    EXPECT_GT(point.whole().min[1], -0.01);
}

// Where no bound in doubles holds, boxes have no ends.
TEST(TurnBoxes, WithoutABoundContainEverything) {
    const Aabb unit{Vec3::Zero(), Vec3::Ones()};
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Turn& turn :
         {Turn{{-1, 0, 0, 0x1p-40}, Vec3::Zero(), Vec3::Zero()}, Turn{{1, 0, 0, 0x1p-600}, Vec3::Zero(), Vec3::Zero()},
          Turn{{1, 0, 0, 1}, Vec3(0x1p1010, 0, 0), Vec3(0x1p1010, 0, 0)}}) {
        EXPECT_EQ(TurnBoxes(unit, turn).whole().max, Vec3::Constant(infinity).eval());
    }
    const Aabb half{{-infinity, -infinity, -infinity}, {infinity, infinity, 0}};
    EXPECT_EQ(TurnBoxes(half, about({1, 0, 0}, 1, Vec3::Zero())).whole().max, Vec3::Constant(infinity).eval());
}

}  // namespace
}  // namespace ecods::turn_boxes_test
