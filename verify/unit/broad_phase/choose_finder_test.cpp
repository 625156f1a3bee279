#include "broad_phase/choose_finder.hpp"

#include <gtest/gtest.h>

namespace ecods::test {
namespace {

constexpr auto sweep = BroadPhaseKind::sweep_and_prune;
constexpr auto kept = BroadPhaseKind::kept_candidates;

BroadPhaseKind after(ChooseFinder& chooser, int updates, const ChooseFinder::Work& work) {
    BroadPhaseKind kind = sweep;
    for (int i = 0; i < updates; ++i) kind = chooser.choose(work);
    return kind;
}

TEST(ChooseFinder, SmallOrRestingScenesAreSwept) {
    ChooseFinder chooser;
    EXPECT_EQ(after(chooser, 100, {.size = 200, .moved = 200, .swaps = 100'000}), sweep) << "small";
    EXPECT_EQ(after(chooser, 100, {.size = 100'000, .moved = 10, .swaps = 10'000}), sweep) << "nearly at rest";
}

TEST(ChooseFinder, LivelyScenesAreNot) {
    ChooseFinder all_move;
    EXPECT_EQ(after(all_move, 2, {.size = 1000, .moved = 1000, .swaps = 0}), kept);
    ChooseFinder tenth_moves;
    EXPECT_EQ(after(tenth_moves, 16, {.size = 1000, .moved = 100, .swaps = 0}), kept) << "all, in a while";
    ChooseFinder few_move_far;
    EXPECT_EQ(after(few_move_far, 6, {.size = 10'000, .moved = 100, .swaps = 100'000}), sweep);
    EXPECT_EQ(after(few_move_far, 1, {.size = 10'000, .moved = 100, .swaps = 100'000}), kept) << "1 in 16, many swaps";
    ChooseFinder few_move_little;
    EXPECT_EQ(after(few_move_little, 100, {.size = 10'000, .moved = 100, .swaps = 800}), sweep);
}

TEST(ChooseFinder, DoesNotSwitchBackUntilFewAreLeft) {
    ChooseFinder chooser;
    ASSERT_EQ(after(chooser, 2, {.size = 1000, .moved = 1000, .swaps = 0}), kept);
    EXPECT_EQ(after(chooser, 1000, {.size = 1000, .moved = 0, .swaps = 0}), kept);
    EXPECT_EQ(after(chooser, 1, {.size = 64, .moved = 64, .swaps = 0}), kept);
    EXPECT_EQ(after(chooser, 1, {.size = 63, .moved = 63, .swaps = 0}), sweep);
    EXPECT_EQ(after(chooser, 100, {.size = 256, .moved = 256, .swaps = 0}), sweep) << "grown again, not enough";
}

// Counts decide: the same work, the same choices.
TEST(ChooseFinder, Repeats) {
    ChooseFinder a, b;
    for (std::size_t i = 0; i < 500; ++i) {
        const ChooseFinder::Work work{.size = 10 + i * 37 % 700, .moved = i * 53 % 300, .swaps = i * 811 % 9000};
        EXPECT_EQ(a.choose(work), b.choose(work));
    }
}

}  // namespace
}  // namespace ecods::test
