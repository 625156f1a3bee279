// Every instruction set is used equally often, for as many sets as any processor has: no processor is needed for it.
#include "fuzz/script/schedule.hpp"
#include "environment/float_mode.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace ecods::fuzz {
namespace {

using environment::float_modes;

constexpr std::size_t world_count = 4;
constexpr std::size_t mode_count = float_modes.size();

class ScheduleTest : public testing::TestWithParam<std::size_t> {
  protected:
    std::size_t set_count() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Sets, ScheduleTest, testing::Values(1, 2, 3), testing::PrintToStringParamName());

// By how much the counts differ.
std::size_t spread(const std::vector<std::size_t>& counts) {
    const auto [least, most] = std::ranges::minmax(counts);
    return most - least;
}

TEST_P(ScheduleTest, EachWorldIsUpdatedEquallyOftenWithEachSet) {
    for (std::size_t world = 0; world < world_count; ++world) {
        std::vector<std::size_t> counts(set_count());
        for (std::size_t round = 0; round < 100; ++round) {
            ++counts.at(scheduled_set(round, world, set_count()));
            EXPECT_LE(spread(counts), 1U) << "world " << world << ", round " << round;
        }
    }
}

TEST_P(ScheduleTest, NeighbouringWorldsAreUpdatedWithDifferentSets) {
    if (set_count() == 1) return;
    for (std::size_t round = 0; round < 12; ++round) {
        for (std::size_t world = 1; world < world_count; ++world) {
            EXPECT_NE(scheduled_set(round, world, set_count()), scheduled_set(round, world - 1, set_count()));
        }
    }
}

TEST_P(ScheduleTest, EachWorldIsAskedEquallyOftenWithEachSet) {
    std::vector<std::size_t> of_sets(set_count());
    std::vector<std::size_t> of_pairs(world_count * set_count());
    for (std::size_t check = 0; check < 200; ++check) {
        const Turn turn = scheduled_turn(check, world_count, set_count(), mode_count);
        ASSERT_LT(turn.world, world_count);
        ++of_sets.at(turn.set);
        ++of_pairs.at(turn.world * set_count() + turn.set);
        EXPECT_LE(spread(of_sets), 1U) << check;
        EXPECT_LE(spread(of_pairs), 1U) << check;
    }
}

TEST_P(ScheduleTest, EachWorldIsAskedEquallyOftenWithEachSetInEachFloatMode) {
    const std::size_t period = world_count * set_count() * mode_count;
    std::vector<std::size_t> counts(period);
    for (std::size_t check = 0; check < 2 * period; ++check) {
        const Turn turn = scheduled_turn(check, world_count, set_count(), mode_count);
        ++counts.at((turn.world * set_count() + turn.set) * mode_count + turn.mode);
        if ((check + 1) % period == 0) {
            EXPECT_EQ(spread(counts), 0U) << check;
        }
    }
}

}  // namespace
}  // namespace ecods::fuzz
