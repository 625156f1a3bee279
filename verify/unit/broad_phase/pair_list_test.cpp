#include "broad_phase/changes/pair_list.hpp"

#include <gtest/gtest.h>

#include "unit/broad_phase/lockstep.hpp"

namespace ecods::pair_list_test {
namespace {

using test::Pairs;
using Proxies = std::vector<ProxyIndex>;

// The six pairs of four proxies, a chosen subset of them.
Pairs subset(unsigned bits) {
    const Pairs all = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    Pairs result;
    for (unsigned i = 0; i < all.size(); ++i) {
        if ((bits >> i & 1u) != 0) result.push_back(all[i]);
    }
    return result;
}

// A list, and the events that it follows.
struct Followed {
    PairEvents events;
    PairList list{events};

    void change(unsigned ended, unsigned began) {
        list.begin_update();
        events = {.began = subset(began), .ended = subset(ended)};
        list.end_update();
    }
    const Pairs& sorted() { return list.sorted(); }
};

TEST(PairList, EveryChangeOfEverySubsetOfSixPairs) {
    for (unsigned before = 0; before < 64; ++before) {
        for (unsigned after = 0; after < 64; ++after) {
            for (const bool is_read_between : {true, false}) {
                Followed list;
                list.change(0, before);
                if (is_read_between) {
                    EXPECT_EQ(list.sorted(), subset(before));
                }
                list.change(before & ~after, after & ~before);
                ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
                // What ended and began again is in both lists, and stays.
                list.change(after, after);
                if (is_read_between) {
                    ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
                }
                list.change(0, 0);
                ASSERT_EQ(list.sorted(), subset(after)) << before << " " << after;
            }
        }
    }
}

TEST(PairList, UnreadEventsOfManyUpdatesCountInTheirOrder) {
    for (unsigned sequence = 0; sequence < 4096; ++sequence) {
        Followed list;
        unsigned here = 0;
        for (unsigned step = 0; step < 4; ++step) {
            const unsigned turned = sequence >> (3 * step) & 7u;
            list.change(here & turned, turned & ~here);
            here ^= turned;
        }
        ASSERT_EQ(list.sorted(), subset(here)) << sequence;
    }
}

// What was found is the list; what ended is what was there and was not found, or lost a box, and what began the rest.
TEST(PairList, ComparingReportsTheDifferenceAndThePairsOfRemovedBoxes) {
    for (const Proxies& removed : {Proxies{}, Proxies{0}, Proxies{1, 3}}) {
        ProxyTable table;
        for (ProxyIndex proxy = 0; proxy < 4; ++proxy) table.add(proxy, test::make_cube(0, 0, 0));
        table.collect();
        table.settle();
        unsigned cut = 0;
        for (const ProxyIndex proxy : removed) {
            table.remove(proxy);
            table.add(proxy, test::make_cube(0, 0, 0));
            for (unsigned i = 0; i < 6; ++i) {
                const ProxyPair pair = subset(1u << i).front();
                if (pair.a == proxy || pair.b == proxy) cut |= 1u << i;
            }
        }
        const ProxyChanges& changes = table.collect();
        for (unsigned before = 0; before < 64; ++before) {
            for (unsigned after = 0; after < 64; ++after) {
                Followed list;
                list.change(0, before);
                Pairs found = subset(after);
                list.list.begin_update();
                list.list.compare(table, changes, found, list.events);
                list.list.end_update();
                ASSERT_EQ(list.sorted(), subset(after));
                ASSERT_EQ(list.events.began, subset(after & ~(before & ~cut)));
                ASSERT_EQ(list.events.ended, subset(before & (cut | ~after)));
            }
        }
    }
}

// A list that nobody reads must not collect events for ever.
TEST(PairList, EventsOfOnePairDoNotPileUp) {
    Followed list;
    for (int i = 0; i < 100'000; ++i) list.change(i % 2 == 0 ? 0 : 1, i % 2 == 0 ? 1 : 0);
    EXPECT_LT(list.list.bytes(), 100'000u);
    EXPECT_TRUE(list.sorted().empty());
}

TEST(PairList, NormaliseSortsAndLeavesEachOnce) {
    Pairs pairs = {{2, 3}, {0, 9}, {2, 3}, {0, 1}, {2, 3}};
    normalise(pairs);
    EXPECT_EQ(pairs, (Pairs{{0, 1}, {0, 9}, {2, 3}}));
}

}  // namespace
}  // namespace ecods::pair_list_test
