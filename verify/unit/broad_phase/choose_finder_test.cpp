#include "broad_phase/choose_finder.hpp"

#include <gtest/gtest.h>

namespace ecods::test::choose_finder_test {
namespace {

constexpr auto sweep = BroadPhaseKind::sweep_and_prune;
constexpr auto kept = BroadPhaseKind::kept_candidates;

TEST(ChooseFinder, SmallScenesAreSweptLargeOnesAreNot) {
    EXPECT_EQ(choose_finder(sweep, 0), sweep);
    EXPECT_EQ(choose_finder(sweep, 32), sweep);
    EXPECT_EQ(choose_finder(sweep, 33), kept);
    EXPECT_EQ(choose_finder(sweep, 1'000'000), kept);
}

TEST(ChooseFinder, DoesNotSwitchBackUntilFewAreLeft) {
    EXPECT_EQ(choose_finder(kept, 33), kept);
    EXPECT_EQ(choose_finder(kept, 32), kept);
    EXPECT_EQ(choose_finder(kept, 16), kept);
    EXPECT_EQ(choose_finder(kept, 15), sweep);
}

}  // namespace
}  // namespace ecods::test::choose_finder_test
