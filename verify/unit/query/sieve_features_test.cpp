// Pairs of a sieve that share their features count once: all small cases against a model.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "sieve_model.hpp"

namespace ecods::sieve_features_test {
namespace {

using namespace sieve_model;

// Pairs with features: certain ones have the number of their features, others guess them.
struct Featured {
    Item item;
    bool is_certain;
    int a, b;

    auto features() const { return std::tuple(is_certain, a, b, is_certain ? TrianglePair{} : item.triangles); }
    Open open() const {
        Open open = item.open();
        open.interval.is_certain = is_certain;
        open.interval.a = a;
        open.interval.b = b;
        return open;
    }
};

// Calls use(pairs) with all sequences of four, with triangles in descending and in no order.
template <class Use>
void with_features(const Use& use) {
    constexpr Real real_of[2][2] = {{3, 3}, {5, 4}};
    std::vector<Featured> kinds;
    for (const Known known : {Known::tight, Known::from_below, Known::rounded}) {
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) kinds.push_back({{real_of[a][b], known}, true, a, b});
        }
    }
    for (const Real real : {3, 5}) kinds.push_back({{real, Known::tight}, false, 0, 0});
    for (std::size_t number = 0; number < kinds.size() * kinds.size() * kinds.size() * kinds.size(); ++number) {
        std::vector<Featured> pairs;
        std::size_t rest = number;
        for (std::uint32_t i = 0; i < 4; ++i, rest /= kinds.size()) {
            pairs.push_back(kinds[rest % kinds.size()]);
            pairs.back().item.triangles = {1 + (3 * i + 2) % 5, 4 - i};
        }
        use(pairs);
        if (testing::Test::HasFailure()) return;
    }
}
TestSieve sieve_of(const std::vector<Featured>& pairs) {
    TestSieve sieve;
    sieve.start({});
    for (const Featured& pair : pairs) sieve.add(pair.open());
    return sieve;
}
const Featured& pair_of(const std::vector<Featured>& pairs, const TrianglePair& triangles) {
    return *std::ranges::find(pairs, triangles, [](const Featured& pair) { return pair.item.triangles; });
}

TEST(SieveFeatures, ASharedFeatureCountsOnceAndHasItsLeastTriangles) {
    with_features([](const std::vector<Featured>& pairs) {
        Real least = infinite;
        for (const Featured& pair : pairs) least = std::min(least, pair.item.real);
        std::set<TrianglePair> expected;
        for (const Featured& pair : pairs) {
            if (pair.item.real != least) continue;
            TrianglePair first = pair.item.triangles;
            for (const Featured& other : pairs) {
                if (other.features() == pair.features()) first = std::min(first, other.item.triangles);
            }
            expected.insert(first);
        }
        TestSieve sieve = sieve_of(pairs);
        const std::vector<TrianglePair> kept =
            triangles_of(sieve.keep_least([&](const TrianglePair& x, const TrianglePair& y) {
                const Real p = pair_of(pairs, x).item.real, q = pair_of(pairs, y).item.real;
                return (p > q) - (p < q);
            }));
        ASSERT_EQ(kept.size(), expected.size());
        ASSERT_EQ(std::set(kept.begin(), kept.end()), expected);

        std::set<decltype(pairs[0].features())> rounded;
        TestSieve other = sieve_of(pairs);
        other.least(
            [&](const Open& open, const auto&) {
                const Featured& pair = pair_of(pairs, open.triangles);
                EXPECT_TRUE(rounded.insert(pair.features()).second) << "rounded twice";
                return std::optional(pair.item.value());
            },
            [](const Value& v) { return v.number; }, [](const Value& v) { return v.rank; });
    });
}

}  // namespace
}  // namespace ecods::sieve_features_test
