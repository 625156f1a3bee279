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
    w.trace->end_update(w.digest(), w.collisions.positive().size());
}

// Updates the lists of collisions, of close pairs and of relations. All operations that can fail come before commit().
void World::Impl::update() {
    if (changes.empty() && closeness.is_up_to_date() && relations.is_up_to_date()) {
        collisions.clear_events();
        closeness.idle();
        statistics.cache_hits += collisions.verdicts().enabled_count();
    } else {
        collisions.follow(broad_phase, bodies, statistics.visited_pairs);
        collisions.collect(bodies, changes, false, statistics.visited_pairs);
        test_pairs();
        closeness.follow(broad_phase, bodies, changes, collisions);
        test_close_pairs();
        relations.follow(bodies, collisions);
        relate_pairs();
        collisions.prepare();
        closeness.prepare();
        relations.prepare(changes);
        commit();
    }
    ++statistics.updates;
}

void World::Impl::commit() noexcept {
    const std::size_t test_count = collisions.commit();
    closeness.commit();
    relations.commit();
    for (const ProxyIndex proxy : changes.bodies()) {
        statistics.moved_bodies += bodies[proxy].is_alive() && changes.of(proxy) == Change::body;
    }
    changes.clear();
    bodies.trim();
    statistics.two_body_tests += test_count;
    statistics.cache_hits += collisions.verdicts().enabled_count() - test_count;
}

}  // namespace ecods
