// Sequences that broke broad phases in the field, by the name under which they were collected.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::hard_cases_test {
namespace {

// The box of a unit cube turned by 45 degrees about z.
Aabb make_turned_cube(double x, double y, double z) {
    const double h = std::sqrt(2.0) / 2;
    return make_box(x - h, x + h, y - h, y + h, z - 0.5, z + 0.5);
}

// FCL's sweep and prune misses boxes that come to touch exactly.
TEST(HardCases, bp_sap_touch) {
    Lockstep lockstep;
    lockstep.add(0, make_cube(0.5, 0.5, 0.5));
    lockstep.add(1, make_cube(3.5, 0.5, 0.5));
    ASSERT_TRUE(lockstep.update());
    lockstep.move(1, make_cube(1.5, 0.5, 0.5));
    ASSERT_TRUE(lockstep.update());
    EXPECT_EQ(lockstep.model.pairs, (Pairs{{0, 1}}));
    lockstep.move(1, make_cube(3.5, 0.5, 0.5));
    ASSERT_TRUE(lockstep.update());
    EXPECT_TRUE(lockstep.model.pairs.empty());
}

// ... and pairs of boxes that grow in place.
TEST(HardCases, bp_sap_grow) {
    Lockstep lockstep;
    const double places[] = {0, 1.2, -5, 5};
    for (ProxyIndex i = 0; i < 4; ++i) lockstep.add(i, make_cube(places[i], 0, 0));
    ASSERT_TRUE(lockstep.update());
    lockstep.move(0, make_turned_cube(0, 0, 0));
    ASSERT_TRUE(lockstep.update());
    EXPECT_EQ(lockstep.model.pairs, (Pairs{{0, 1}}));
}

// ... and loops for ever when one that grew moves on.
TEST(HardCases, bp_sap_hang) {
    Lockstep lockstep;
    lockstep.add(0, make_cube(0, 0, 0));
    lockstep.add(1, make_cube(5, 0, 0));
    ASSERT_TRUE(lockstep.update());
    lockstep.move(0, make_turned_cube(0, 0, 0));
    ASSERT_TRUE(lockstep.update());
    lockstep.move(0, make_turned_cube(-1, 0, 0));
    ASSERT_TRUE(lockstep.update());
    EXPECT_TRUE(lockstep.model.pairs.empty());
}

TEST(HardCases, bp_sap_empty) {
    for (const auto kind : all_kinds) {
        const auto phase = make_broad_phase(kind);
        EXPECT_EQ(phase->size(), 0u);
        phase->add(0, make_cube(0, 0, 0));
        EXPECT_EQ(phase->size(), 1u);
    }
}

// ... and uses freed memory after one of four is removed. In every order.
TEST(HardCases, bp_sap_unregister_uaf) {
    std::array<ProxyIndex, 4> order = {0, 1, 2, 3};
    do {
        Lockstep lockstep;
        for (ProxyIndex i = 0; i < 4; ++i) lockstep.add(i, make_cube(0.75 * i, 0, 0));
        ASSERT_TRUE(lockstep.update());
        for (const ProxyIndex proxy : order) {
            lockstep.remove(proxy);
            ASSERT_TRUE(lockstep.update());
            for (ProxyIndex i = 0; i < 4; ++i) {
                if (lockstep.model.has(i)) lockstep.move(i, make_cube(0.75 * i, 0.01 * proxy, 0));
            }
            ASSERT_TRUE(lockstep.update());
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

// ... and crashes when one that it never saw is removed.
TEST(HardCases, bp_sap_unregister_unknown) {
    Lockstep lockstep;
    lockstep.add(0, make_cube(0, 0, 0));
    lockstep.add(1, make_cube(0, 0, 0));
    ASSERT_TRUE(lockstep.update());
    for (const auto& engine : lockstep.engines) EXPECT_ANY_THROW(engine->remove(2));
    ASSERT_TRUE(lockstep.update());
    EXPECT_EQ(lockstep.model.pairs, (Pairs{{0, 1}}));
}

// A sweep with < for <= loses boxes without volume that touch. On each axis, points and flat boxes.
TEST(HardCases, bp_ifclite_2292) {
    for (int axis = 0; axis < 3; ++axis) {
        Lockstep lockstep;
        lockstep.add(0, make_interval(axis, 2, 2));
        lockstep.add(1, make_interval(axis, 2, 2));
        lockstep.add(2, make_interval(axis, 1, 2));
        lockstep.add(3, make_interval(axis, 2, 3));
        lockstep.add(4, make_box(1, 1, 1, 1, 1, 1));
        ASSERT_TRUE(lockstep.update());
        EXPECT_EQ(lockstep.model.pairs, (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}, {2, 4}}));
    }
}

// FCL's tree swaps pairs over in an update in which nothing moved.
TEST(HardCases, bp_fcl_368) {
    Lockstep lockstep;
    for (ProxyIndex i = 0; i < 20; ++i) lockstep.add(19 - i, make_cube(0.3 * i, 0.1 * (i % 3), 0));
    ASSERT_TRUE(lockstep.update());
    const Pairs pairs = lockstep.engines[1]->pairs();
    ASSERT_FALSE(pairs.empty());
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(lockstep.update());
        EXPECT_EQ(lockstep.engines[1]->pairs(), pairs);
        EXPECT_TRUE(lockstep.engines[1]->began().empty());
    }
}

// Chipmunk's tree overflows the stack: 50,000 shapes, sorted as they come, then all gone in the order they came.
TEST(HardCases, bp_chipmunk_231) {
    const auto phase = make_broad_phase(BroadPhaseKind::sweep_and_prune);
    constexpr ProxyIndex count = 50'000;
    for (ProxyIndex i = 0; i < count; ++i) phase->add(i, make_cube(i, 0, 0));
    phase->update();
    EXPECT_EQ(phase->pairs().size(), count - 1) << "each touches the next";
    for (ProxyIndex i = 0; i < count; ++i) phase->remove(i);
    phase->update();
    EXPECT_TRUE(phase->pairs().empty());
    EXPECT_EQ(phase->ended().size(), count - 1);
    phase->check_invariants();
}

// Coal's sweep and prune walked its lists wrongly on update; two half-spaces in one tree were lost.
TEST(HardCases, bp_coal_501_and_750) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Lockstep lockstep;
    lockstep.add(0, make_box(-infinity, infinity, -infinity, infinity, -infinity, 0));
    lockstep.add(1, make_box(-infinity, infinity, -infinity, 0, -infinity, infinity));
    lockstep.add(2, make_cube(3, 3, 3));
    lockstep.add(3, make_cube(-3, -3, -3));
    ASSERT_TRUE(lockstep.update());
    EXPECT_EQ(lockstep.model.pairs, (Pairs{{0, 1}, {0, 3}, {1, 3}}));
    for (int step = 0; step < 20; ++step) {
        lockstep.move(2, make_cube(3 - 0.5 * step, 3, 3 - 0.5 * step));
        lockstep.move(3, make_cube(-3 + 0.5 * step, -3 + 0.5 * step, -3));
        ASSERT_TRUE(lockstep.update());
    }
}

// One that awoke was given a fat box that reaches another's, which had just moved away from it and towards where it
// goes: they were candidates twice.
TEST(HardCases, FewThatRestAndAwakeInTurn) {
    constexpr ProxyIndex count = 10;
    constexpr int updates = 60;
    std::uint64_t state = 1;
    const auto next = [&](std::uint64_t end) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<int>((state >> 33) % end);
    };
    for (int scene = 0; scene < 150; ++scene) {
        const auto phase = make_broad_phase(BroadPhaseKind::kept_candidates);
        const auto model = make_broad_phase(BroadPhaseKind::brute_force);
        std::array<int, count> at{};  // in tenths of a size, along one line
        const auto place = [&](ProxyIndex proxy) { return make_cube(0.1 * at[proxy], 0, 0); };
        for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
            at[proxy] = next(60);
            phase->add(proxy, place(proxy));
            model->add(proxy, place(proxy));
        }
        for (int update = 0; update < updates; ++update) {
            for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
                if (next(8) != 0) continue;
                at[proxy] += next(5) - 2;
                phase->move(proxy, place(proxy));
                model->move(proxy, place(proxy));
            }
            phase->update();
            model->update();
            ASSERT_NO_THROW(phase->check_invariants()) << scene << ", " << update;
            ASSERT_TRUE(std::ranges::equal(phase->pairs(), model->pairs())) << scene << ", " << update;
        }
    }
}

// Candidates are decided by the upper halves of coordinates where these differ. Far from the origin they never do, nor
// where all boxes lie on a lattice; nearer, a part of them does.
TEST(HardCases, CandidatesFarFromTheOriginAndOnALattice) {
    std::uint64_t state = 1;
    const auto next = [&](std::uint64_t end) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>((state >> 33) % end);
    };
    for (const double far : {0.0, 0x1p15, -0x1p19, 0x1p30}) {
        for (const double step : {1.0, 0.037}) {
            Lockstep lockstep;
            constexpr ProxyIndex count = 60;
            std::array<Vec3, count> at;
            for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
                at[proxy] = Vec3(far + next(8), next(4), far + next(3));
                lockstep.add(proxy, make_cube(at[proxy].x(), at[proxy].y(), at[proxy].z(), 2));
            }
            ASSERT_TRUE(lockstep.update());
            for (int update = 0; update < 90; ++update) {
                for (ProxyIndex proxy = 0; proxy < count; ++proxy) {
                    if (next(4) == 0) continue;
                    at[proxy] += step * Vec3(next(3) - 1, next(3) - 1, next(3) - 1) / (update < 70 ? 16 : 1);
                    lockstep.move(proxy, make_cube(at[proxy].x(), at[proxy].y(), at[proxy].z(), 2));
                }
                ASSERT_TRUE(lockstep.update()) << far << ", " << step << ", " << update;
            }
        }
    }
}

}  // namespace
}  // namespace ecods::test::hard_cases_test
