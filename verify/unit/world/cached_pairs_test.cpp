#include "world/cached_pairs.hpp"

#include <gtest/gtest.h>

#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::cached_pairs_test {
namespace {

Aabb box_at(scenes::Random& random) {
    const Vec3 corner(random.below(12), random.below(3), random.below(3));
    return {.min = corner, .max = corner + Vec3::Constant(1 + random.below(2))};
}

// Adds the pairs that began to the cache, and takes out those that ended.
void follow(const PairEvents& events, VerdictCache& cache) {
    cache.reserve(cache.size() + events.began.size(), 64);
    for (const ProxyPair pair : events.ended) cache.remove(pair);
    for (const ProxyPair pair : events.began) cache.add({BodyId{pair.a + 1, 0}, BodyId{pair.b + 1, 0}});
}

class CachedPairsInEveryBroadPhase : public testing::TestWithParam<BroadPhaseKind> {};
INSTANTIATE_TEST_SUITE_P(BroadPhases, CachedPairsInEveryBroadPhase, broad_phases(), broad_phase_name);

// Whether the pairs are kept in the cache or in a sorted list, the events are the same: with few changes and with many,
// with boxes that go, come back in the same place between two updates, or jump.
TEST_P(CachedPairsInEveryBroadPhase, AnswerAsASortedListDoes) {
    scenes::Random random(7);
    OverlapTracker with_list(GetParam()), with_cache(GetParam());
    PairList list(with_list.events());
    VerdictCache cache;
    constexpr ProxyIndex count = 64;
    for (int update = 0; update < 300; ++update) {
        const std::uint32_t change_count = random.below(3) == 0 ? 60 : random.below(4);
        for (std::uint32_t i = 0; i < change_count; ++i) {
            const ProxyIndex proxy = random.below(count);
            const Aabb box = box_at(random);
            const bool is_present = with_list.table().is_present(proxy);
            const std::uint32_t what = random.below(3);
            for (OverlapTracker* tracker : {&with_list, &with_cache}) {
                if (is_present && what == 0) tracker->remove(proxy);
                if (is_present && what == 1) tracker->remove(proxy), tracker->add(proxy, box);
                if (is_present && what == 2) tracker->move(proxy, box);
                if (!is_present) tracker->add(proxy, box);
            }
        }
        list.begin_update();
        with_list.update(list);
        list.end_update();
        CachedPairs pairs(cache);
        with_cache.update(pairs);
        ASSERT_EQ(with_cache.events().began, with_list.events().began) << update;
        ASSERT_EQ(with_cache.events().ended, with_list.events().ended) << update;
        follow(with_cache.events(), cache);
        ASSERT_EQ(cache.size(), list.sorted().size()) << update;
        EXPECT_EQ(with_cache.counts().box_tests, with_list.counts().box_tests);
    }
}

// Of two boxes that go at once, the pair ends once.
TEST(CachedPairs, APairOfTwoBoxesThatGoEndsOnce) {
    ProxyTable table;
    VerdictCache cache;
    const Aabb box{.min = Vec3(0, 0, 0), .max = Vec3(1, 1, 1)};
    for (ProxyIndex proxy = 0; proxy < 3; ++proxy) table.add(proxy, box);
    table.collect();
    table.settle();
    follow({.began = {{0, 1}, {0, 2}, {1, 2}}, .ended = {}}, cache);
    table.remove(2);
    table.remove(0);
    ProxyPairs ended;
    CachedPairs(cache).append_removed(table, table.collect(), ended);
    normalise(ended);
    EXPECT_EQ(ended.size(), 3u);
    ProxyPairs again;
    CachedPairs(cache).append_removed(table, table.collect(), again);
    EXPECT_EQ(again.size(), 3u) << "each once";
}

}  // namespace
}  // namespace ecods::cached_pairs_test
