#include "world/cached_pairs.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void World::update() {
    Impl& w = impl();
    if (!w.trace) return w.update();
    w.trace->begin_update();
    try {
        w.update();
    } catch (...) {
        w.trace->end_failed_update();
        throw;
    }
    w.trace->end_update(w.digest(), w.collisions.colliding().size());
}

void World::Impl::update() {
    if (changes.empty()) {
        collisions.clear_events();
        statistics.cache_hits += collisions.verdicts().enabled_count();
    } else {
        take_over_candidates();
        collisions.collect(bodies, changes, statistics.visited_pairs);
        test_pairs();
        commit();
    }
    ++statistics.updates;
}

// Brings the candidate pairs to those that the broad phase has now. Events that an earlier update could not take over,
// for want of memory, come first.
void World::Impl::take_over_candidates() {
    if (!broad_phase.events().empty()) take_over_events();
    CachedPairs pairs(collisions.verdicts());
    broad_phase.update(pairs);
    take_over_events();
}

void World::Impl::take_over_events() {
    const PairEvents& events = broad_phase.events();
    collisions.take_over(events, bodies);
    statistics.visited_pairs += events.began.size() + events.ended.size();
    broad_phase.clear_events();
}

void World::Impl::commit() {
    const std::size_t test_count = collisions.commit();
    // Nothing below throws.
    for (const ProxyIndex proxy : changes.bodies()) {
        statistics.moved_bodies += bodies[proxy].is_alive() && changes.of(proxy) == Change::body;
    }
    changes.clear();
    statistics.two_body_tests += test_count;
    statistics.cache_hits += collisions.verdicts().enabled_count() - test_count;
}

}  // namespace ecods
