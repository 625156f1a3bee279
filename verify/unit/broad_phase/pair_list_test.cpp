#include "broad_phase/changes/pair_list.hpp"

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

void change(PairList& list, unsigned ended, unsigned began) {
    list.begin_update();
    list.ended = subset(ended);
    list.began = subset(began);
    std::reverse(list.began.begin(), list.began.end());
    list.end_update();
}

TEST(PairList, EveryChangeOfEverySubsetOfSixPairs) {
    for (unsigned before = 0; before < 64; ++before) {
        for (unsigned after = 0; after < 64; ++after) {
            for (const bool is_read_between : {true, false}) {
                PairList list;
                change(list, 0, before);
                if (is_read_between) {
                    EXPECT_EQ(list.sorted(), subset(before));
                }
                change(list, before & ~after, after & ~before);
                ASSERT_EQ(list.began, subset(after & ~before));
                ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
                // What ended and began again is in both lists, and stays.
                change(list, after, after);
                if (is_read_between) {
                    ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
                }
                change(list, 0, 0);
                ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
            }
        }
    }
}

TEST(PairList, UnreadEventsOfManyUpdatesCountInTheirOrder) {
    for (unsigned sequence = 0; sequence < 4096; ++sequence) {
        PairList list;
        unsigned here = 0;
        for (unsigned step = 0; step < 4; ++step) {
            const unsigned turned = sequence >> (3 * step) & 7u;
            change(list, here & turned, turned & ~here);
            here ^= turned;
        }
        ASSERT_EQ(list.sorted(), subset(here)) << sequence;
    }
}

TEST(PairList, ReplacingReportsTheDifferenceAndKeepsWhatEndedOtherwise) {
    for (unsigned before = 0; before < 64; ++before) {
        for (unsigned after = 0; after < 64; ++after) {
            for (const unsigned cut : {0u, before, before & 0b010110u}) {
                PairList list;
                change(list, 0, before);
                Pairs found = subset(after);
                list.begin_update();
                list.ended = subset(cut);
                list.replace(found);
                list.end_update();
                ASSERT_EQ(list.sorted(), subset(after));
                ASSERT_EQ(list.began, subset(after & ~(before & ~cut)));
                ASSERT_EQ(list.ended, subset(cut | (before & ~after)));
            }
        }
    }
}

// A list that nobody reads must not collect events for ever.
TEST(PairList, EventsOfOnePairDoNotPileUp) {
    PairList list;
    for (int i = 0; i < 100'000; ++i) change(list, i % 2 == 0 ? 0 : 1, i % 2 == 0 ? 1 : 0);
    EXPECT_LT(list.bytes(), 100'000u);
    EXPECT_TRUE(list.sorted().empty());
}

TEST(PairList, NormaliseSortsAndLeavesEachOnce) {
    Pairs pairs = {{2, 3}, {0, 9}, {2, 3}, {0, 1}, {2, 3}};
    normalise(pairs);
    EXPECT_EQ(pairs, (Pairs{{0, 1}, {0, 9}, {2, 3}}));
}

}  // namespace
}  // namespace ecods
