// The pairs within the clearance, as updates keep them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/thread_executor.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_clearance_test {
namespace {

using Pairs = std::vector<BodyPair>;

constexpr double infinity = std::numeric_limits<double>::infinity();

class WorldClearanceTest : public EachWorld {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldClearanceTest, broad_phases(), broad_phase_name);

TEST_P(WorldClearanceTest, WithoutAClearanceTheListsAreEmpty) {
    world.create_body(cube, at(0));
    world.create_body(cube, at(0.5));
    world.update();
    EXPECT_EQ(world.clearance(), std::nullopt);
    EXPECT_TRUE(world.close_pairs().empty());
    EXPECT_TRUE(world.close_began().empty());
    EXPECT_EQ(world.statistics().clearance.candidate_count, 0u);
    EXPECT_EQ(world.statistics().clearance.broad_phase.updates, 0u);
    world.check_invariants();
}

TEST_P(WorldClearanceTest, ANewClearanceCountsAtTheNextUpdateAndGivesEvents) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(1.25));
    const BodyId c = world.create_body(cube, at(3));
    const BodyPair ab{a, b}, bc{b, c};
    world.update();
    world.set_clearance(0.25);
    EXPECT_EQ(world.clearance(), 0.25);
    EXPECT_TRUE(world.close_pairs().empty());
    world.update();
    EXPECT_EQ(list(world.close_pairs()), (Pairs{ab})) << "at exactly the clearance";
    EXPECT_EQ(list(world.close_began()), (Pairs{ab}));
    EXPECT_TRUE(world.colliding_pairs().empty());
    EXPECT_TRUE(world.began().empty());
    world.check_invariants();
    world.update();
    EXPECT_TRUE(world.close_began().empty());
    world.set_clearance(0.75);
    world.update();
    EXPECT_EQ(list(world.close_pairs()), (Pairs{ab, bc}));
    EXPECT_EQ(list(world.close_began()), (Pairs{bc}));
    EXPECT_TRUE(world.close_ended().empty());
    world.check_invariants();
    world.set_clearance(std::nextafter(0.25, 0));
    world.update();
    EXPECT_TRUE(world.close_pairs().empty()) << "decided for the real number";
    EXPECT_EQ(list(world.close_ended()), (Pairs{ab, bc}));
    world.check_invariants();
    world.set_clearance(0.25);
    world.update();
    world.set_clearance({});
    EXPECT_EQ(world.clearance(), std::nullopt);
    EXPECT_EQ(list(world.close_pairs()), (Pairs{ab})) << "until the next update";
    world.update();
    EXPECT_TRUE(world.close_pairs().empty());
    EXPECT_EQ(list(world.close_ended()), (Pairs{ab}));
    world.check_invariants();
    world.update();
    EXPECT_TRUE(world.close_ended().empty());
    world.set_clearance(0.25);
    world.update();
    EXPECT_EQ(list(world.close_began()), (Pairs{ab}));
    world.check_invariants();
}

TEST_P(WorldClearanceTest, CollidingPairsAreCloseWithoutATest) {
    world.create_body(cube, at(0));
    world.create_body(cube, at(0.5));
    world.create_body(cube, at(1.5));
    world.set_clearance(0.0);
    world.update();
    EXPECT_EQ(list(world.close_pairs()), list(world.colliding_pairs()));
    EXPECT_EQ(world.close_pairs().size(), 2u) << "the last two touch";
    EXPECT_EQ(world.statistics().clearance.two_body_tests, 0u);
    EXPECT_EQ(world.statistics().clearance.close_count, 2u);
}

TEST_P(WorldClearanceTest, WorkIsThatOfWhatMoved) {
    std::vector<BodyId> bodies;
    for (int i = 0; i < 10; ++i) bodies.push_back(world.create_body(cube, at(1.5 * i)));
    world.set_clearance(0.5);
    world.update();
    EXPECT_EQ(world.close_pairs().size(), 9u);
    const auto before = world.statistics().clearance;
    EXPECT_EQ(before.two_body_tests, 9u);
    world.update();
    EXPECT_EQ(world.statistics().clearance.two_body_tests, 9u);
    EXPECT_EQ(world.statistics().clearance.cache_hits, before.cache_hits + 9);
    world.set_pose(bodies[4], at(6.125));
    world.update();
    EXPECT_EQ(world.statistics().clearance.two_body_tests, 10u) << "of two neighbours one is within reach";
    EXPECT_EQ(list(world.close_ended()), (Pairs{{bodies[3], bodies[4]}}));
    world.destroy_body(bodies[5]);
    world.update();
    EXPECT_EQ(world.close_ended().size(), 2u);
    EXPECT_EQ(world.statistics().clearance.two_body_tests, 10u);
    world.check_invariants();
}

TEST_P(WorldClearanceTest, ASlotThatIsUsedAgainIsAnotherBody) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(1.25));
    world.set_clearance(0.5);
    world.update();
    world.destroy_body(b);
    const BodyId c = world.create_body(cube, at(1.25));
    EXPECT_EQ(b.slot, c.slot);
    world.update();
    EXPECT_EQ(list(world.close_ended()), (Pairs{{a, b}}));
    EXPECT_EQ(list(world.close_began()), (Pairs{{a, c}}));
    world.check_invariants();
}

TEST_P(WorldClearanceTest, FiltersAndSwitchesApply) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(1.25));
    world.set_clearance(0.5);
    world.set_pair_enabled(a, b, false);
    world.update();
    EXPECT_TRUE(world.close_pairs().empty());
    EXPECT_EQ(world.statistics().clearance.filtered_count, 1u);
    world.set_pair_enabled(a, b, true);
    world.update();
    EXPECT_EQ(world.close_began().size(), 1u);
    world.set_filter(a, {.mask = 0});
    world.update();
    EXPECT_EQ(world.close_ended().size(), 1u);
    world.check_invariants();
}

TEST_P(WorldClearanceTest, BadDistancesAreRefused) {
    world.set_clearance(1.0);
    for (const double bad : {-1.0, -0x1p-1074, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_INVALID(world.set_clearance(bad), Argument::distance);
    }
    EXPECT_EQ(world.clearance(), 1.0);
    world.set_clearance(-0.0);
    EXPECT_FALSE(std::signbit(*world.clearance()));
    world.set_clearance(std::numeric_limits<double>::max());
    world.create_body(cube, at(0));
    world.create_body(cube, at(1e300));
    world.update();
    EXPECT_EQ(world.close_pairs().size(), 1u);
    world.check_invariants();
}

// The least and the largest boxes and clearances.
TEST_P(WorldClearanceTest, AllScales) {
    for (const int exponent : {-1060, -1022, -900, -500, 0, 500, 900, 1020}) {
        World scaled{WorldOptions{GetParam()}};
        const double unit = std::ldexp(1.0, exponent);
        Pose pose;
        pose.R *= unit;
        const auto at_times = [&](double x) {
            pose.t = Vec3(x * unit, 0, 0);
            return pose;
        };
        const BodyId a = scaled.create_body(cube, at_times(0));
        const BodyId b = scaled.create_body(cube, at_times(1.25));
        scaled.set_clearance(0.25 * unit);
        scaled.update();
        EXPECT_EQ(list(scaled.close_pairs()), (Pairs{{a, b}})) << exponent;
        scaled.set_clearance(std::nextafter(0.25 * unit, 0));
        scaled.update();
        EXPECT_TRUE(scaled.close_pairs().empty()) << exponent;
        scaled.check_invariants();
    }
}

// Bodies that jump, come and go, and a clearance that changes: the lists of all kinds, with and without an executor,
// are what asking all pairs says.
class WorldsWithAClearance : public testing::Test {
  protected:
    static constexpr std::uint32_t body_count = 40;

    WorldsWithAClearance() {
        for (const auto kind : {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
            worlds.emplace_back(WorldOptions{.broad_phase = kind});
            worlds.emplace_back(WorldOptions{.broad_phase = kind, .executor = std::make_shared<ThreadExecutor>(3)});
        }
        ids.resize(worlds.size());
        for (std::uint32_t i = 0; i < body_count; ++i) {
            const Pose pose = any_pose();
            in_all([&](World& world, auto& bodies) { bodies.push_back(world.create_body(meshes[i % 3], pose)); });
        }
    }

    template <class Act>
    void in_all(const Act& act) {
        for (std::size_t w = 0; w < worlds.size(); ++w) act(worlds[w], ids[w]);
    }

    Pose any_pose() { return at(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)); }

    void set_any_clearance(int frame) {
        const std::optional<double> d = frame % 28 == 21 ? std::nullopt : std::optional(random.uniform(0, 0.7));
        in_all([&](World& world, auto&) { world.set_clearance(d); });
    }

    void change_bodies(int frame) {
        for (int change = 0; change < 6; ++change) {
            const std::uint32_t which = random.below(body_count);
            const Pose pose = any_pose();
            in_all([&](World& world, auto& bodies) {
                if (change != 5 || frame % 3 != 0) return world.set_pose(bodies[which], pose);
                world.destroy_body(bodies[which]);
                bodies[which] = world.create_body(meshes[which % 3], pose);
            });
        }
    }

    Pairs pairs_by_asking_all() {
        Pairs pairs;
        World& first = worlds[0];
        const auto bodies = first.bodies();
        for (std::size_t i = 0; i < bodies.size() && first.clearance(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                if (first.within(bodies[i], bodies[j], *first.clearance())) pairs.push_back({bodies[i], bodies[j]});
            }
        }
        return pairs;
    }

    void expect_lists(const Pairs& expected, const Pairs& before, bool checks_invariants) {
        Pairs began, ended;
        std::ranges::set_difference(expected, before, std::back_inserter(began));
        std::ranges::set_difference(before, expected, std::back_inserter(ended));
        const World& first = worlds[0];
        EXPECT_EQ(list(first.close_pairs()), expected);
        EXPECT_EQ(list(first.close_began()), began);
        EXPECT_EQ(list(first.close_ended()), ended);
        in_all([&](World& world, auto&) {
            EXPECT_EQ(world.digest(), first.digest());
            EXPECT_EQ(numbers_of(world.close_pairs()), numbers_of(expected));
            EXPECT_EQ(numbers_of(world.close_began()), numbers_of(began));
            EXPECT_EQ(numbers_of(world.close_ended()), numbers_of(ended));
            const ClearanceStatistics got = world.statistics().clearance, counts = first.statistics().clearance;
            EXPECT_EQ(got.two_body_tests, counts.two_body_tests);
            EXPECT_EQ(got.cache_hits, counts.cache_hits);
            EXPECT_EQ(got.candidate_count, counts.candidate_count);
            if (checks_invariants) world.check_invariants();
        });
    }

    scenes::Random random{7};
    std::array<std::shared_ptr<const Mesh>, 3> meshes = {scenes::cube(0.5), scenes::cube(0.125), scenes::cube(1)};
    std::vector<World> worlds;
    std::vector<std::vector<BodyId>> ids;  // by world
};

TEST_F(WorldsWithAClearance, HaveWhatAllPairsSayWhateverMoves) {
    Pairs before;
    std::size_t close_count = 0;
    for (int frame = 0; frame < 60; ++frame) {
        SCOPED_TRACE(frame);
        if (frame % 7 == 0) set_any_clearance(frame);
        change_bodies(frame);
        in_all([](World& world, auto&) { world.update(); });
        const Pairs expected = pairs_by_asking_all();
        expect_lists(expected, before, frame % 10 == 0);
        if (HasFailure()) return;
        before = expected;
        close_count += expected.size();
    }
    EXPECT_GT(close_count, 200u);
}

}  // namespace
}  // namespace ecods::world_clearance_test
