// Casts of a body that turns, or is translated, beside one that goes straight to a pose, for every family of
// turn_cases.hpp, beside the oracle, and the oracle beside pieces of the time.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "ecods/error.hpp"
#include "judge/text.hpp"
#include "judge/turn_and_straight_truth.hpp"
#include "judge/turn_truth.hpp"
#include "scenes/each_case.hpp"
#include "scenes/turn_cases.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods {
namespace {

// Returns the kinds of contacts, each with how often it was met. Pieces of the time are asked about few triangles.
std::map<std::string, int> ask_families(int seed, bool turns, int& pieces) {
    scenes::Random random(static_cast<std::uint64_t>(seed));
    std::map<std::string, int> kinds;
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(scenes::turn_families(), seed, 6, [&](const scenes::TurnCase& made) {
        const std::size_t pairs = made.a->triangles().size() * made.b->triangles().size();
        const Vec3 way = made.turn.pivot_to - made.turn.pivot_from;
        if (pairs > 36 || testing::Test::HasFatalFailure()) return;
        const MeshShape a(made.a), b(made.b);
        const Motion motion = turns ? Motion(made.turn) : Translation{way.allFinite() ? way : Vec3(Vec3::Zero())};
        const Pose to = scenes::pose_beside(random, made);
        const judge::TurnAndStraightTruth truth({a, made.pose_a}, motion, {b, made.pose_b, to});
        const auto wrong = truth.ask(memory, witness);
        ASSERT_FALSE(wrong) << wrong->question << ": " << wrong->got << " in place of " << wrong->expected << ", "
                            << judge::text(made.turn);
        ++kinds[truth.contact() ? judge::written(truth.contact()->kind) : "nothing"];
        if (pairs > 4) return;
        ++pieces;
        ASSERT_EQ(truth.contradiction().value_or(""), "") << judge::text(made.turn);
    });
    return kinds;
}

TEST(CastStraightFamilies, BesideATurn) {
    int pieces = 0;
    EXPECT_GE(ask_families(11, true, pieces).size(), 4U);
    EXPECT_GT(pieces, 10);
}

TEST(CastStraightFamilies, BesideATranslation) {
    int pieces = 0;
    EXPECT_GE(ask_families(12, false, pieces).size(), 4U);
    EXPECT_GT(pieces, 10);
}

// Numbers of all sizes, side by side: each is a small integer times one of three powers of two. Casts end, and are
// right.
TEST(CastStraightFamilies, NumbersOfAllSizes) {
    scenes::Random random(13);
    QueryMemory memory;
    PairWitness witness;
    int met = 0, refused = 0;
    for (int run = 0; run < 100; ++run) {
        std::array<double, 3> units;
        for (double& unit : units) unit = std::ldexp(1.0, static_cast<int>(random.below(1900)) - 1000);
        if (run % 3 == 0) units = {0x1p-700, 0x1p-610, run % 2 == 0 ? 0x1p-1070 : 0x1p-500};
        if (run % 3 == 1) units[1] = units[2] = units[0];
        const auto number = [&](std::uint32_t most) {
            return units[random.below(3)] * (static_cast<double>(random.below(2 * most + 1)) - most);
        };
        const auto vector = [&] { return Vec3(number(3), number(3), number(3)); };
        const auto small = [&] { return static_cast<double>(random.below(5)) - 2; };
        const auto pose = [&] {
            Pose result{Mat3::Identity(), vector()};
            if (random.below(2) == 0) result.R << small(), small(), 0, 0, small(), 1, small(), 0, small();
            return result;
        };
        const MeshShape a = shape_of({vector(), vector(), vector()}), b = shape_of({vector(), vector(), vector()});
        Turn turn{{1 + std::abs(small()), small(), small(), small()}, vector(), vector()};
        if (random.below(2) == 0) turn.pivot_to = turn.pivot_from;
        const Motion motion = run % 4 == 0 ? Motion(Translation{vector()}) : turn;
        const judge::TurnAndStraightTruth truth({a, pose()}, motion, {b, pose(), pose()});
        try {
            const auto wrong = truth.ask(memory, witness);
            ASSERT_FALSE(wrong) << run << ": " << wrong->question << ": " << wrong->got << " in place of "
                                << wrong->expected;
            met += truth.contact() && truth.contact()->time > 0;
        } catch (const NotSupported&) {
            ++refused;
        }
    }
    EXPECT_GT(met, 10);
    EXPECT_LT(refused, 100);
}

}  // namespace
}  // namespace ecods
