// Work is proportional to what moved: counts prove it.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test {
namespace {

struct Work {
    std::uint64_t moved, box_tests, swaps;
};

Work work_of_update(BroadPhase& phase) {
    const BroadPhaseCounts before = phase.counts();
    phase.update();
    const BroadPhaseCounts& after = phase.counts();
    return {after.moved - before.moved, after.box_tests - before.box_tests, after.swaps - before.swaps};
}

// A cubic grid of unit cubes, two apart.
std::unique_ptr<BroadPhase> make_grid(BroadPhaseKind kind, int side) {
    auto phase = make_broad_phase(kind);
    ProxyIndex proxy = 0;
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            for (int z = 0; z < side; ++z) phase->add(proxy++, make_cube(2 * x, 2 * y, 2 * z));
        }
    }
    phase->update();
    return phase;
}

TEST(Counts, AnUpdateWithoutChangesDoesNothing) {
    for (const auto kind : all_kinds) {
        const auto phase = make_grid(kind, 8);
        for (ProxyIndex proxy = 0; proxy < 512; ++proxy) phase->move(proxy, phase->box(proxy));
        const Work work = work_of_update(*phase);
        EXPECT_EQ(work.moved, 0u);
        EXPECT_EQ(work.box_tests, 0u);
        EXPECT_EQ(work.swaps, 0u);
    }
}

TEST(Counts, BruteForceTestsAllPairsWhenAnythingMoved) {
    const auto phase = make_grid(BroadPhaseKind::brute_force, 4);
    phase->move(0, make_cube(0.1, 0, 0));
    EXPECT_EQ(work_of_update(*phase).box_tests, 64u * 63 / 2);
}

TEST(Counts, OneMoverThatPassesNoEndCostsNoSwap) {
    const auto phase = make_grid(BroadPhaseKind::sweep_and_prune, 20);
    // Odd ones out first: the ends of a grid coincide, which makes even a small step pass many.
    const ProxyIndex loner = 8000;
    phase->add(loner, make_cube(100, 100, 100));
    phase->update();
    phase->move(loner, make_cube(101, 100, 100));
    const Work work = work_of_update(*phase);
    EXPECT_EQ(work.moved, 1u);
    EXPECT_EQ(work.swaps, 0u);
    EXPECT_EQ(work.box_tests, 0u);
}

TEST(Counts, ACommonTranslationCostsNoSwap) {
    const auto phase = make_grid(BroadPhaseKind::sweep_and_prune, 8);
    for (ProxyIndex proxy = 0; proxy < 512; ++proxy) {
        Aabb box = phase->box(proxy);
        box.min.array() += 1024;
        box.max.array() += 1024;
        phase->move(proxy, box);
    }
    const Work work = work_of_update(*phase);
    EXPECT_EQ(work.moved, 512u);
    EXPECT_EQ(work.swaps, 0u);
}

// Inserting 50,000 boxes must not be quadratic, nor need a deep stack: on a line, a plane, in space.
TEST(Counts, AddingFiftyThousandAtOnceIsNotQuadratic) {
    constexpr int count = 50'000;
    for (int arrangement = 0; arrangement < 3; ++arrangement) {
        const auto phase = make_broad_phase(BroadPhaseKind::sweep_and_prune);
        for (int i = 0; i < count; ++i) {
            const int side = arrangement == 0 ? count : arrangement == 1 ? 224 : 37;
            const int layer = arrangement == 2 ? side * side : count;
            // Axis 0 alone tells nothing on the line.
            phase->add(i, make_cube(2 * (i / layer), 2 * (i % side), 2 * (i / side % side)));
        }
        const Work work = work_of_update(*phase);
        EXPECT_TRUE(phase->pairs().empty());
        const double quadratic = 0.5 * count * count;
        EXPECT_LT(double(work.box_tests), quadratic / 30) << arrangement;
        EXPECT_EQ(work.swaps, 0u);
        // One more costs a pass, as the lists do: each box there is looks into a tree of one block.
        phase->add(count, make_cube(1, 1, 1, 0.5));
        EXPECT_LT(work_of_update(*phase).box_tests, 8u * count + 100) << arrangement;
    }
}

// When all boxes jump, insertion is given up for sorting anew: the swaps stay below what was allowed.
TEST(Counts, TeleportingAllIsNotQuadraticInSwaps) {
    Lockstep lockstep;
    constexpr int count = 1000;
    const auto place = [&](int i, int stride) { return make_cube(2.0 * (i * stride % count), 0, 0); };
    for (int i = 0; i < count; ++i) lockstep.add(i, place(i, 1));
    ASSERT_TRUE(lockstep.update());
    const std::uint64_t before = lockstep.sweep_counts().swaps;
    for (int i = 0; i < count; ++i) lockstep.move(i, place(i, 617));
    ASSERT_TRUE(lockstep.update());
    const std::uint64_t swaps = lockstep.sweep_counts().swaps - before;
    EXPECT_GE(swaps, 256u * count);
    EXPECT_LE(swaps, 260u * count);
}

}  // namespace
}  // namespace ecods::test
