#include "broad_phase/choose_finder.hpp"

#include <gtest/gtest.h>

namespace ecods::test::choose_finder_test {
namespace {

constexpr auto sweep = BroadPhaseKind::sweep_and_prune;
constexpr auto kept = BroadPhaseKind::kept_candidates;

TEST(ChooseFinder, SmallScenesAreSweptLargeOnesAreNot) {
    ChooseFinder chooser;
    EXPECT_EQ(chooser.choose(0), sweep);
    EXPECT_EQ(chooser.choose(32), sweep);
    EXPECT_EQ(chooser.choose(33), kept);
    EXPECT_EQ(chooser.choose(1'000'000), kept);
}

TEST(ChooseFinder, DoesNotSwitchBackUntilFewAreLeft) {
    ChooseFinder chooser;
    ASSERT_EQ(chooser.choose(33), kept);
    EXPECT_EQ(chooser.choose(32), kept);
    EXPECT_EQ(chooser.choose(16), kept);
    EXPECT_EQ(chooser.choose(15), sweep);
    EXPECT_EQ(chooser.choose(32), sweep) << "grown again, not enough";
}

}  // namespace
}  // namespace ecods::test::choose_finder_test
