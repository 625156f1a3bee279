// The sieve against a model that knows the real numbers: all small cases.
#include "query/search/sieve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sieve_model.hpp"

namespace ecods::sieve_test {
namespace {

using namespace sieve_model;

TEST(Sieve, KeepsAllThatBeginUpToTheLeastUpperBound) {
    with_all(3, [](const Items& items) {
        for (int at_most = 0; at_most <= key_end + 1; ++at_most) {
            SearchGoal goal;
            goal.at_most = double_at(at_most <= key_end ? at_most : infinite);
            TestSieve sieve = sieved(items, goal);
            int most = key_at(goal.at_most), upper = infinite;
            PairWitness nearest;
            for (const Item& item : items) {
                if (item.lower() > most) continue;
                if (item.upper() < upper || nearest.a == PairWitness::none) nearest = {item.triangles.a, 0};
                upper = std::min(upper, item.upper());
                most = std::min(most, upper);
            }
            std::vector<TrianglePair> kept;
            for (const Item& item : items) {
                if (item.lower() <= most) kept.push_back(item.triangles);
            }
            ASSERT_EQ(triangles_of(sieve.open()), kept) << text_of(items) << " at most " << at_most;
            ASSERT_EQ(key_at(sieve.upper()), upper) << text_of(items);
            ASSERT_EQ(key_at(sieve.bound()), most) << text_of(items);
            ASSERT_EQ(sieve.nearest().a, nearest.a) << text_of(items);
        }
    });
}

TEST(Sieve, IsDecidedByAnUpperBoundThatReachesTheGoal) {
    with_all(2, [](const Items& items) {
        for (int stop_at = 0; stop_at <= key_end; ++stop_at) {
            SearchGoal goal;
            goal.stop_at = double_at(stop_at);
            const bool is_reached = std::min(items[0].upper(), items[1].upper()) <= stop_at;
            ASSERT_EQ(sieved(items, goal).is_decided(), is_reached) << text_of(items) << " stop at " << stop_at;
            ASSERT_FALSE(sieved(items).is_decided());
        }
    });
}

TEST(Sieve, SaysWhichUpperBoundsLeaveOutMore) {
    TestSieve sieve;
    sieve.start({});
    EXPECT_FALSE(sieve.take_upper(double_at(infinite), {7, 8}));
    EXPECT_EQ(sieve.nearest().a, 7u) << "the first pair is known even if nothing is known of it";
    EXPECT_TRUE(sieve.take_upper(double_at(3), {1, 2}));
    EXPECT_FALSE(sieve.take_upper(double_at(3), {3, 4}));
    EXPECT_FALSE(sieve.take_upper(double_at(4), {3, 4}));
    EXPECT_EQ(sieve.nearest().b, 2u) << "the first of equal ones";
    EXPECT_TRUE(sieve.take_upper(double_at(2), {5, 6}));
    EXPECT_EQ(sieve.nearest().a, 5u);
}

TEST(Sieve, ACommonPointDecides) {
    TestSieve sieve;
    sieve.start({});
    sieve.take_upper(double_at(3), {1, 2});
    sieve.add({{}, {1, 2}});
    EXPECT_FALSE(sieve.is_zero() || sieve.is_decided());
    sieve.take_zero({5, 6});
    EXPECT_TRUE(sieve.is_zero() && sieve.is_decided());
    EXPECT_EQ(sieve.nearest().b, 6u);
    sieve.start({});
    EXPECT_FALSE(sieve.is_zero() || sieve.is_decided());
    EXPECT_TRUE(sieve.open().empty());
    EXPECT_EQ(sieve.nearest().a, PairWitness::none);
    EXPECT_EQ(key_at(sieve.upper()), infinite);
    sieve.take_zero();
    EXPECT_TRUE(sieve.is_decided());
}

// A round of the sieve's open pairs: what is asked, and that it had to be.
struct Rounds {
    const Items& items;
    int count = 0, last_upper = 0;

    std::optional<Value> operator()(const Open& open, const std::optional<Value>& least) {
        const Item& item = item_of(items, open.triangles);
        EXPECT_FALSE(open.value) << "what is known is not rounded again" << text_of(items);
        EXPECT_LE(last_upper, item.upper()) << "the least upper bounds come first" << text_of(items);
        EXPECT_TRUE(!least || item.lower() <= key_at(least->number)) << "out of question" << text_of(items);
        last_upper = item.upper();
        ++count;
        if (least && key_above(item.real) > key_at(least->number)) return {};
        return item.value();
    }
};
std::optional<Value> least_of(TestSieve& sieve, Rounds& round) {
    return sieve.least(
        round, [](const Value& v) { return v.number; }, [](const Value& v) { return v.rank; });
}

TEST(Sieve, TheLeastValueIsThatOfAllPairs) {
    with_all(3, [](const Items& items) {
        const auto order = [](const Item& item) { return std::pair(key_above(item.real), item.rank); };
        const Item& first = *std::ranges::min_element(items, {}, order);
        for (int at_most = 0; at_most <= key_end + 1; ++at_most) {
            SearchGoal goal;
            goal.at_most = double_at(at_most <= key_end ? at_most : infinite);
            TestSieve sieve = sieved(items, goal);
            const std::vector<Open> open = sieve.open();
            Rounds rounds{items};
            const std::optional<Value> least = least_of(sieve, rounds);
            ASSERT_EQ(least.has_value(), !open.empty());
            if (!least) continue;
            ASSERT_EQ(order(item_of(items, {sieve.nearest().a, 0})), std::pair(key_at(least->number), least->rank));
            ASSERT_LE(key_at(sieve.upper()), key_at(least->number));
            if (key_above(first.real) <= key_at(goal.at_most)) {
                ASSERT_EQ(std::pair(key_at(least->number), least->rank), order(first)) << text_of(items);
            } else {
                ASSERT_GT(key_at(least->number), key_at(goal.at_most)) << text_of(items);
            }
        }
    });
}

TEST(Sieve, AsksExactlyOnlyWhereIntervalsLeaveItOpen) {
    with_all(3, [](const Items& items) {
        for (int d = 0; d <= key_end; ++d) {
            for (const int at_most : {d, infinite}) {
                SearchGoal goal;
                goal.at_most = double_at(at_most);
                TestSieve sieve = sieved(items, goal);
                const bool is_within = sieve.is_least_within(double_at(d), [&](const TrianglePair& triangles) {
                    const Item& item = item_of(items, triangles);
                    EXPECT_LE(item.lower(), d) << text_of(items);
                    EXPECT_TRUE(item.known == Known::rounded || item.upper() > d) << text_of(items);
                    return item.real <= 2 * d;
                });
                const auto is_one = [&](const Item& item) { return item.real <= 2 * d; };
                ASSERT_EQ(is_within, std::ranges::any_of(items, is_one)) << text_of(items) << " within " << d;
                ASSERT_TRUE(!is_within || is_one(item_of(items, {sieve.nearest().a, 0}))) << text_of(items);
            }
        }
    });
}

TEST(Sieve, KeepsAllTies) {
    with_all(3, [](const Items& items) {
        TestSieve sieve = sieved(items);
        const Real least = std::ranges::min(items, {}, &Item::real).real;
        const auto compare = [&](const TrianglePair& x, const TrianglePair& y) {
            const Item &p = item_of(items, x), &q = item_of(items, y);
            EXPECT_LE(p.lower(), q.upper()) << "known to be more" << text_of(items);
            EXPECT_LE(q.lower(), p.upper()) << "known to be less" << text_of(items);
            return (p.real > q.real) - (p.real < q.real);
        };
        std::set<TrianglePair> kept, expected;
        for (const TrianglePair& triangles : triangles_of(sieve.keep_least(compare))) {
            ASSERT_TRUE(kept.insert(triangles).second) << "twice" << text_of(items);
        }
        for (const Item& item : items) {
            if (item.real == least) expected.insert(item.triangles);
        }
        ASSERT_EQ(kept, expected) << text_of(items);
    });
}

// A pair that comes twice, once measured and once as the witness, counts once, and is not measured again.
TEST(Sieve, APairThatComesAgainKeepsItsValue) {
    for (const bool is_measured_first : {false, true}) {
        Item bounded{3, Known::tight}, measured{3, Known::rounded};
        const Items items = is_measured_first ? Items{measured, bounded} : Items{bounded, measured};
        TestSieve sieve = sieved(items);
        ASSERT_EQ(sieve.open().size(), 2u);
        Rounds rounds{items};
        ASSERT_TRUE(least_of(sieve, rounds));
        EXPECT_EQ(rounds.count, 0);
        EXPECT_EQ(sieve.open().size(), 1u);
    }
}

// A node may be left out if the interval that is then known is as narrow as either width allows.
TEST(Sieve, TheFloorIsWithinATolerancesWidth) {
    const double none = std::numeric_limits<double>::infinity();
    for (const double upper : {none, 3.0, 2.0, 1.0, 0.0}) {
        for (const double absolute : {0.0, 0.5, 1.0, 4.0}) {
            for (const double relative : {0.0, 0.5, 1.0, 3.0}) {
                for (const double at_most : {none, 2.0}) {
                    TestSieve sieve;
                    sieve.start({.at_most = at_most, .relative = relative, .absolute = absolute});
                    sieve.take_upper(upper, {});
                    const double widest = std::min(upper - absolute, upper / (1 + relative));
                    EXPECT_LE(sieve.floor(), upper);
                    EXPECT_GE(sieve.floor(), std::max(widest, 0.0));
                    EXPECT_TRUE(upper - absolute != upper / (1 + relative) || sieve.floor() == widest) << upper;
                    EXPECT_EQ(sieve.bound(), std::min(at_most, sieve.floor()));
                    EXPECT_EQ(sieve.counts(upper), upper <= at_most) << "only nodes are left out for the tolerance";
                }
            }
        }
    }
}

TEST(IsWithin, AsksOnlyWhereTheIntervalContainsTheLimit) {
    with_all(1, [](const Items& items) {
        const Item& item = items.front();
        for (int d = 0; d <= key_end; ++d) {
            bool is_asked = false;
            const bool answer = is_within(double_at(key_below(item.real)), double_at(item.upper()), double_at(d), [&] {
                is_asked = true;
                return item.real <= 2 * d;
            });
            ASSERT_EQ(answer, item.real <= 2 * d) << item.real << " within " << d;
            ASSERT_EQ(is_asked, key_below(item.real) <= d && item.upper() > d) << item.real << " within " << d;
        }
    });
}

}  // namespace
}  // namespace ecods::sieve_test
