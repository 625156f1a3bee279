#include "broad_phase/pair_events.hpp"

#include <gtest/gtest.h>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods {
namespace {

using test::Pairs;

// The six pairs of four proxies, a chosen subset of them.
Pairs subset(unsigned bits) {
    const Pairs all = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    Pairs result;
    for (unsigned i = 0; i < all.size(); ++i) {
        if ((bits >> i & 1u) != 0) result.push_back(all[i]);
    }
    return result;
}

TEST(PairEvents, EveryChangeOfEverySubsetOfSixPairs) {
    for (unsigned before = 0; before < 64; ++before) {
        for (unsigned after = 0; after < 64; ++after) {
            Pairs pairs = subset(before);
            apply_events(subset(before & ~after), subset(after & ~before), pairs);
            ASSERT_EQ(pairs, subset(after)) << before << " " << after;
            // What ended and began again is in both lists, and stays.
            apply_events(subset(after), subset(after), pairs);
            ASSERT_EQ(pairs, subset(after)) << before << " " << after;
        }
    }
}

TEST(PairEvents, ReplacingReportsTheDifferenceAndKeepsWhatEndedOtherwise) {
    for (unsigned before = 0; before < 64; ++before) {
        for (unsigned after = 0; after < 64; ++after) {
            for (const unsigned cut : {0u, before, before & 0b010110u}) {
                Pairs pairs = subset(before);
                Pairs found = subset(after);
                Pairs began;
                Pairs ended = subset(cut);
                replace_pairs(found, pairs, began, ended);
                ASSERT_EQ(pairs, subset(after));
                ASSERT_EQ(began, subset(after & ~(before & ~cut)));
                ASSERT_EQ(ended, subset(cut | (before & ~after)));
            }
        }
    }
}

TEST(PairEvents, NormaliseSortsAndLeavesEachOnce) {
    Pairs pairs = {{2, 3}, {0, 9}, {2, 3}, {0, 1}, {2, 3}};
    normalise(pairs);
    EXPECT_EQ(pairs, (Pairs{{0, 1}, {0, 9}, {2, 3}}));
}

}  // namespace
}  // namespace ecods
