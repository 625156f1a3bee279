// Work is proportional to what moved: counts prove it.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::counts_test {
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

template <class Boxes>
void shift(Boxes& boxes, ProxyIndex proxy, const Aabb& box, const Vec3& by) {
    boxes.move(proxy, {.min = box.min + by, .max = box.max + by});
}
void shift(BroadPhase& phase, ProxyIndex proxy, const Vec3& by) {
    shift(phase, proxy, phase.box(proxy), by);
}
void shift(Lockstep& lockstep, ProxyIndex proxy, const Vec3& by) {
    shift(lockstep, proxy, lockstep.model.box(proxy), by);
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
    for (ProxyIndex proxy = 0; proxy < 512; ++proxy) shift(*phase, proxy, Vec3::Constant(1024));
    const Work work = work_of_update(*phase);
    EXPECT_EQ(work.moved, 512u);
    EXPECT_EQ(work.swaps, 0u);
}

// A frame in which one box of many moves costs what that box costs, whether or not it finds other pairs.
TEST(Counts, OneMoverAmongManyCostsWhatItCosts) {
    const auto phase = make_grid(BroadPhaseKind::kept_candidates, 40);
    phase->pairs();
    for (int step = 1; step <= 100; ++step) {
        const BroadPhaseCounts before = phase->counts();
        phase->move(32'000, make_cube(40 + 0.02 * step, 40, 40));
        phase->update();
        const BroadPhaseCounts& after = phase->counts();
        EXPECT_EQ(after.moved - before.moved, 1u);
        EXPECT_LE(after.candidates_filtered - before.candidates_filtered, 27u);
        EXPECT_LE(after.box_tests - before.box_tests, 1000u);
        EXPECT_EQ(after.rebuilds, before.rebuilds);
        EXPECT_LE(phase->began().size() + phase->ended().size(), 8u);
    }
    EXPECT_GE(phase->counts().escaped, 2u);
    EXPECT_LE(phase->counts().escaped, 50u) << "a box on its way has room for many steps";
}

// What lay at rest has no margin: to look it up where it was, and then again where it goes, takes twice the tests.
TEST(Counts, BoxesThatAwakeAreLookedUpOnce) {
    const auto phase = make_grid(BroadPhaseKind::kept_candidates, 20);
    constexpr ProxyIndex awaking = 80, every = 100;
    for (ProxyIndex i = 0; i < awaking; ++i) shift(*phase, i * every, Vec3::Constant(0.01));
    const Work work = work_of_update(*phase);
    EXPECT_GT(work.box_tests, 32 * awaking);
    EXPECT_LT(work.box_tests, 72 * awaking);
    // They have margins now.
    for (ProxyIndex i = 0; i < awaking; ++i) shift(*phase, i * every, Vec3::Constant(0.01));
    EXPECT_EQ(work_of_update(*phase).box_tests, 0u);
    EXPECT_NO_THROW(phase->check_invariants());
}

TEST(Counts, BoxesOnTheirWayAreFilteredAndNotSearched) {
    const auto phase = make_grid(BroadPhaseKind::kept_candidates, 12);
    for (int step = 1; step <= 60; ++step) {
        for (ProxyIndex proxy = 0; proxy < 1728; ++proxy) {
            shift(*phase, proxy, Vec3(proxy % 2 == 0 ? 0x1p-7 : -0x1p-7, 0, 0));
        }
        phase->update();
    }
    const BroadPhaseCounts& counts = phase->counts();
    EXPECT_LE(counts.rebuilds, 8u);
    EXPECT_LE(counts.escaped, 8u * 1728);
    EXPECT_LE(counts.candidates_filtered, 60u * 1728 * 6);
    phase->check_invariants();
}

// Boxes that leave any margin at once: each update searches once, and as soon as they are slow, none does.
TEST(Counts, FastBoxesAreSearchedFromScratchUntilTheyAreSlow) {
    Lockstep lockstep;
    constexpr ProxyIndex count = 300;
    const auto step = [&](int frame, double by) {
        for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
            shift(lockstep, proxy, Vec3::Unit(proxy % 3) * ((proxy + frame) % 5 < 2 ? by : -by));
        }
        if (frame % 4 == 3) lockstep.remove(static_cast<ProxyIndex>(frame)), lockstep.add(frame, make_cube(1, 1, 1));
        ASSERT_TRUE(lockstep.update());
    };
    for (ProxyIndex proxy = 0; proxy < count; ++proxy)
        lockstep.add(proxy, make_cube(proxy % 7, proxy / 7 % 7, proxy / 49));
    ASSERT_TRUE(lockstep.update());
    const BroadPhaseCounts& counts = lockstep.counts(BroadPhaseKind::kept_candidates);
    BroadPhaseCounts before = counts;
    for (int frame = 0; frame < 20; ++frame) step(frame, 0.6);
    EXPECT_EQ(counts.rebuilds - before.rebuilds, 20u);
    EXPECT_EQ(counts.candidates_filtered, before.candidates_filtered);
    before = counts;
    for (int frame = 20; frame < 60; ++frame) step(frame, 0x1p-8);
    EXPECT_LE(counts.rebuilds - before.rebuilds, 20u);
    EXPECT_GT(counts.candidates_filtered, before.candidates_filtered);
}

// Cubes of which neighbours overlap.
constexpr ProxyIndex swarm_count = 400;

void add_swarm(Lockstep& lockstep) {
    for (ProxyIndex proxy = 0; proxy < swarm_count; ++proxy)
        lockstep.add(proxy, make_cube(proxy % 8 * 0.9, proxy / 8 % 8 * 1.1, proxy / 64 * 0.7));
}

// Boxes that fly in formation far beyond their size are neither searched nor leave their margins, whatever a few others
// do; nor when they slow down, stop, or fly on.
TEST(Counts, ASwarmThatFliesIsNotSearched) {
    Lockstep lockstep;
    add_swarm(lockstep);
    ASSERT_TRUE(lockstep.update());
    const BroadPhaseCounts& counts = lockstep.counts(BroadPhaseKind::kept_candidates);
    const auto fly = [&](const Vec3& by, int frame) {
        for (ProxyIndex proxy = 0; proxy < swarm_count; ++proxy) {
            shift(lockstep, proxy, by + Vec3::Constant((proxy + frame) % 3 == 0 ? 0x1p-9 : -0x1p-10));
        }
        const ProxyIndex other = static_cast<ProxyIndex>(frame) % swarm_count;
        if (frame % 3 == 0) lockstep.move(other, make_cube(1, frame, 1));
        if (frame % 7 == 0) lockstep.remove(other), lockstep.add(other, lockstep.model.box((other + 1) % swarm_count));
        ASSERT_TRUE(lockstep.update());
    };
    for (int frame = 0; frame < 8; ++frame) fly({40.3, -17, 5}, frame);
    BroadPhaseCounts before = counts;
    for (int frame = 8; frame < 40; ++frame) fly({40.3, -17, 5}, frame);
    EXPECT_LE(counts.rebuilds - before.rebuilds, 16u) << "some come, go and jump; but for them there would be none";
    for (int frame = 40; frame < 50; ++frame) fly({0, 0, 0}, frame);
    for (int frame = 50; frame < 60; ++frame) fly({-3e5, 1e-3, 0}, frame);
    for (int frame = 60; frame < 70; ++frame) fly({1e306, 0, 0}, frame);
}

// A swarm that has flown, and of which most boxes rest then: those that move, come or go find them where they are.
TEST(Counts, ASwarmThatLandedIsFoundWhereItIs) {
    Lockstep lockstep;
    add_swarm(lockstep);
    ASSERT_TRUE(lockstep.update());
    for (int frame = 0; frame < 8; ++frame) {
        for (ProxyIndex proxy = 0; proxy < swarm_count; ++proxy) shift(lockstep, proxy, {40.3, -17, 5});
        ASSERT_TRUE(lockstep.update());
    }
    // As long as it takes until those at rest have no candidates with each other.
    for (int frame = 0; frame < 40; ++frame) {
        shift(lockstep, 7, {0x1p-6, 0, 0});
        shift(lockstep, 300, {0, frame % 2 == 0 ? 0.5 : -0.5, 0});
        ASSERT_TRUE(lockstep.update());
    }
    for (ProxyIndex proxy = 20; proxy < 24; ++proxy) {
        EXPECT_FALSE(lockstep.model.pairs.empty());
        lockstep.remove(proxy);
        ASSERT_TRUE(lockstep.update());
        EXPECT_FALSE(lockstep.model.ended.empty());
    }
}

// One that comes or goes in a resting scene costs what it finds.
TEST(Counts, OneThatComesOrGoesCostsAtMostTenMoves) {
    const auto phase = make_grid(BroadPhaseKind::automatic, 47);  // 103,823
    const auto work = [&] {
        const BroadPhaseCounts before = phase->counts();
        phase->update();
        const BroadPhaseCounts& after = phase->counts();
        return after.box_tests - before.box_tests + after.candidates_filtered - before.candidates_filtered;
    };
    const std::uint64_t rebuilds = phase->counts().rebuilds;
    phase->move(50'000, make_cube(40.25, 40, 40));
    const std::uint64_t of_move = work();
    EXPECT_GT(of_move, 0u);
    phase->add(200'000, make_cube(31, 31, 31));
    EXPECT_LE(work(), 10 * of_move);
    phase->remove(70'000);
    EXPECT_LE(work(), 10 * of_move);
    EXPECT_EQ(phase->counts().rebuilds, rebuilds);
}

// From nothing, by jumping all at once, and of sizes from 1 to 1000: no structure may degrade to n^2.
TEST(Counts, JumpsAndSizesOfThreeDecadesAreNotQuadratic) {
    constexpr ProxyIndex count = 20'000;
    const auto phase = make_broad_phase(BroadPhaseKind::kept_candidates);
    for (int frame = 0; frame < 3; ++frame) {
        std::uint64_t state = 12345 + frame;
        const auto next = [&] { return double((state = state * 6364136223846793005u + 1442695040888963407u) >> 40); };
        for (ProxyIndex i = 0; i < count; ++i) {
            const double size = std::pow(10.0, next() / 0x1p24 * 3);
            const Aabb box = make_cube(next() / 0x1p12, next() / 0x1p12, next() / 0x1p12, size);
            frame == 0 ? phase->add(i, box) : phase->move(i, box);
        }
        const BroadPhaseCounts before = phase->counts();
        phase->update();
        const std::uint64_t tests = phase->counts().box_tests - before.box_tests;
        EXPECT_LT(tests, 400 * count + 20 * phase->pairs().size()) << frame;
    }
}

// The memory of a scene: what the header states for each box and pair.
TEST(Counts, MemoryIsAsStated) {
    for (const auto kind : {BroadPhaseKind::sweep_and_prune, BroadPhaseKind::kept_candidates}) {
        const auto phase = make_broad_phase(kind);
        constexpr ProxyIndex count = 10'000;
        phase->reserve(count);
        for (ProxyIndex i = 0; i < count; ++i) phase->add(i, make_cube(2 * (i % 100), 2 * (i / 100), 0));
        phase->update();
        const double per_box = double(phase->bytes()) / count;
        EXPECT_LE(per_box, kind == BroadPhaseKind::sweep_and_prune ? 280 : 250);
        EXPECT_GE(per_box, 150);
    }
}

TEST(Counts, AutomaticChoosesByTheNumber) {
    const auto phase = make_grid(BroadPhaseKind::automatic, 10);
    EXPECT_EQ(phase->counts().switches, 1u) << "many";
    for (int step = 1; step <= 10; ++step) phase->move(0, make_cube(0.01 * step, 0, 0)), phase->update();
    for (int step = 0; step < 40; ++step) {
        for (ProxyIndex proxy = 0; proxy < 1000; ++proxy) {
            shift(*phase, proxy, Vec3::Unit(proxy % 3) * ((proxy + step) % 7 < 3 ? 0.37 : -0.31));
        }
        phase->update();
        phase->check_invariants();
    }
    EXPECT_EQ(phase->counts().switches, 1u) << "whatever they do";
    for (ProxyIndex proxy = 15; proxy < 1000; ++proxy) phase->remove(proxy);
    phase->update();
    EXPECT_EQ(phase->counts().switches, 2u) << "few are left";
    phase->check_invariants();
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
}  // namespace ecods::test::counts_test
