#include "world/verdict_cache.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "scenes/random.hpp"

namespace ecods::verdict_cache_test {
namespace {

using Model = std::map<ProxyPair, Verdict>;

BodyPair bodies_of(ProxyPair pair, std::uint16_t generation) {
    return {{pair.a + 1, generation}, {pair.b + 1, generation}};
}

std::set<ProxyIndex> partners(const VerdictCache& cache, ProxyIndex proxy) {
    std::set<ProxyIndex> result;
    for (auto index = cache.first(proxy); index != no_verdict; index = cache.next(index, proxy)) {
        const ProxyPair pair = cache[index].proxies();
        EXPECT_TRUE(result.insert(pair.a == proxy ? pair.b : pair.a).second);
    }
    return result;
}

void expect_equal(const VerdictCache& cache, const Model& model, ProxyIndex proxy_end) {
    cache.validate();
    ASSERT_EQ(cache.size(), model.size());
    std::map<ProxyIndex, std::set<ProxyIndex>> expected;
    std::size_t enabled = 0;
    for (const auto& [pair, verdict] : model) {
        const VerdictIndex index = cache.find(pair);
        ASSERT_NE(index, no_verdict);
        EXPECT_EQ(cache[index].bodies, verdict.bodies);
        EXPECT_EQ(cache[index].is_enabled, verdict.is_enabled);
        EXPECT_EQ(cache[index].is_positive, verdict.is_positive);
        enabled += verdict.is_enabled;
        expected[pair.a].insert(pair.b);
        expected[pair.b].insert(pair.a);
    }
    EXPECT_EQ(cache.enabled_count(), enabled);
    for (ProxyIndex proxy = 0; proxy < proxy_end; ++proxy) EXPECT_EQ(partners(cache, proxy), expected[proxy]);
}

TEST(VerdictCache, AnEmptyOneFindsNothing) {
    VerdictCache cache;
    EXPECT_EQ(cache.find({0, 1}), no_verdict);
    EXPECT_EQ(cache.first(5), no_verdict);
    cache.validate();
    cache.reserve(0, 0);
    EXPECT_EQ(cache.find({0, 1}), no_verdict);
    cache.validate();
}

// Against a map, with few bodies and many pairs, then many bodies and few pairs.
TEST(VerdictCache, IsAMapWithLists) {
    scenes::Random random(1);
    for (const ProxyIndex proxy_end : {6u, 40u, 3000u}) {
        VerdictCache cache;
        Model model;
        for (int step = 0; step < 4000; ++step) {
            const ProxyIndex a = random.below(proxy_end), b = random.below(proxy_end);
            if (a == b) continue;
            const ProxyPair pair{std::min(a, b), std::max(a, b)};
            const auto known = model.find(pair);
            // Grows at first, and is emptied at the end.
            const bool removes = random.below(4000) < static_cast<std::uint32_t>(step);
            if (known == model.end() && !removes) {
                cache.reserve(cache.size() + 1, proxy_end);
                const BodyPair bodies = bodies_of(pair, static_cast<std::uint16_t>(random.below(3)));
                cache.add(bodies);
                model[pair].bodies = bodies;
            } else if (known != model.end() && removes) {
                EXPECT_EQ(cache.remove(pair).bodies, known->second.bodies);
                model.erase(known);
            } else if (known != model.end()) {
                known->second.is_enabled = random.below(2) == 0;
                known->second.is_positive = known->second.is_enabled && random.below(2) == 0;
                cache.set(cache.find(pair), known->second.is_enabled, known->second.is_positive);
            }
            EXPECT_EQ(cache.find(pair) != no_verdict, model.contains(pair));
            if (step % 500 == 0) expect_equal(cache, model, proxy_end);
        }
        while (!model.empty()) {
            cache.remove(model.begin()->first);
            model.erase(model.begin());
            if (model.size() % 64 == 0) expect_equal(cache, model, proxy_end);
        }
        EXPECT_EQ(cache.size(), 0u);
    }
}

// One by one or at once, memory grows in steps that double, so that adding a pair costs a constant on average.
TEST(VerdictCache, SmallReservationsGrowGeometrically) {
    VerdictCache cache;
    std::set<std::size_t> sizes;
    for (ProxyIndex i = 1; i <= 10000; ++i) {
        cache.reserve(cache.size() + 1, 10001);
        cache.add(bodies_of({0, i}, 0));
        sizes.insert(cache.memory_bytes());
    }
    EXPECT_LE(sizes.size(), 32u);
    cache.validate();
}

TEST(VerdictCache, MemoryIsWhatTheHeaderSays) {
    EXPECT_EQ(sizeof(Verdict), 44u);
    VerdictCache cache;
    cache.reserve(12, 100);
    // 12 verdicts, 100 bodies, 32 places.
    EXPECT_EQ(cache.memory_bytes(), 12u * 44 + 100u * 4 + 32u * 8);
}

}  // namespace
}  // namespace ecods::verdict_cache_test
