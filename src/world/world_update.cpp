#include <algorithm>

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
    w.trace->end_update(w.digest(), w.colliding.size());
}

void World::Impl::update() {
    const bool is_idle = changed.empty() && switched.empty() && !candidates_are_dirty && !update_failed;
    if (is_idle) {
        began.clear();
        ended.clear();
        statistics.cache_hits += verdicts.enabled_count();
    } else {
        update_failed = true;  // until the end is reached
        take_over_candidates();
        collect_pairs();
        test_pairs();
        commit();
        update_failed = false;
    }
    ++statistics.updates;
}

// Brings the cache to the pairs that the broad phase has now. Events that an earlier update could not take over, for
// want of memory, come first.
void World::Impl::take_over_candidates() {
    if (events_are_pending) take_over_events();
    broad_phase->update();
    events_are_pending = true;
    take_over_events();
    candidates_are_dirty = false;
}

// What ended goes first: where a body's slot was used again, the same pair of slots may end and begin.
void World::Impl::take_over_events() {
    const auto& more = broad_phase->began();
    const auto& gone = broad_phase->ended();
    verdicts.reserve(verdicts.size() + more.size(), slots.size());
    make_room(lost, gone.size());
    // Nothing below throws.
    for (const ProxyPair pair : gone) {
        const Verdict verdict = verdicts.remove(pair);
        if (verdict.is_colliding) lost.push_back(verdict.bodies);
    }
    for (const ProxyPair pair : more) verdicts.add(ids_of(pair));
    statistics.visited_pairs += more.size() + gone.size();
    overlapping_is_stale |= !more.empty() || !gone.empty();
    events_are_pending = false;
}

// Every pair of which a body changed, once. A pair that began has a body that changed. When much changed, all pairs are
// passed over in the order in which they lie; else each body's list is followed.
void World::Impl::collect_pairs() {
    pair_tests.clear();
    if (changed.size() >= slots.size() / 4) {
        statistics.visited_pairs += verdicts.size();
        for (VerdictIndex index = 0; index < verdicts.size(); ++index) {
            const ProxyPair pair = verdicts[index].proxies();
            const bool is_changed = changes[pair.a] != Change::none || changes[pair.b] != Change::none;
            if (is_changed) collect_pair(index);
        }
    } else {
        for (const ProxyIndex proxy : changed) {
            for (auto index = verdicts.first(proxy); index != no_verdict; index = verdicts.next(index, proxy)) {
                ++statistics.visited_pairs;
                const ProxyPair pair = verdicts[index].proxies();
                const ProxyIndex partner = pair.a == proxy ? pair.b : pair.a;
                if (changes[partner] == Change::none || proxy < partner) collect_pair(index);
            }
        }
    }
    std::ranges::sort(switched);
    switched.erase(std::unique(switched.begin(), switched.end()), switched.end());
    statistics.visited_pairs += switched.size();
    for (const ProxyPair pair : switched) {
        const VerdictIndex index = verdicts.find(pair);
        const bool is_new = changes[pair.a] == Change::none && changes[pair.b] == Change::none;
        if (index != no_verdict && is_new) collect_pair(index);
    }
}

// Nothing is asked of a pair that is filtered out, nor of one that was tested before and whose bodies are as they were.
void World::Impl::collect_pair(VerdictIndex index) {
    const Verdict& verdict = verdicts[index];
    const ProxyPair pair = verdict.proxies();
    if (!is_enabled(pair)) {
        if (verdict.is_enabled) pair_tests.push_back({index, Answer::filtered_out});
        return;
    }
    const bool is_void = changes[pair.a] >= Change::test || changes[pair.b] >= Change::test;
    if (is_void || !verdict.is_enabled) pair_tests.push_back({index, Answer::none});
}

void World::Impl::commit() {
    next_began.clear();
    next_ended = lost;
    std::size_t test_count = 0;
    for (const PairTest& done : pair_tests) {
        const Verdict& verdict = verdicts[done.verdict];
        test_count += done.answer != Answer::filtered_out;
        const bool is_colliding = done.answer == Answer::colliding;
        if (is_colliding != verdict.is_colliding) (is_colliding ? next_began : next_ended).push_back(verdict.bodies);
    }
    std::ranges::sort(next_began);
    std::ranges::sort(next_ended);
    // A pair that lost its box overlap and found it again while updates failed has both ended and begun: it went on.
    cancel_common(next_began, next_ended);
    make_room(colliding, next_began.size());
    // Nothing below throws.
    for (const PairTest& done : pair_tests) {
        const bool is_enabled = done.answer != Answer::filtered_out;
        overlapping_is_stale |= is_enabled != verdicts[done.verdict].is_enabled;
        verdicts.set(done.verdict, is_enabled, done.answer == Answer::colliding);
    }
    remove_sorted(colliding, next_ended);
    add_sorted(colliding, next_began);
    began.swap(next_began);
    ended.swap(next_ended);
    lost.clear();
    switched.clear();
    for (const ProxyIndex proxy : changed) {
        statistics.moved_bodies += slots[proxy].is_alive() && changes[proxy] == Change::body;
        changes[proxy] = Change::none;
    }
    changed.clear();
    statistics.two_body_tests += test_count;
    statistics.cache_hits += verdicts.enabled_count() - test_count;
}

// Body by body, so that short lists are sorted, and none of all pairs.
void World::Impl::build_overlapping() {
    if (!overlapping_is_stale) return;
    overlapping.clear();
    overlapping.reserve(verdicts.enabled_count());
    for (ProxyIndex proxy = 0; proxy < verdicts.proxy_end(); ++proxy) {
        const auto old_size = static_cast<std::ptrdiff_t>(overlapping.size());
        for (auto index = verdicts.first(proxy); index != no_verdict; index = verdicts.next(index, proxy)) {
            const Verdict& verdict = verdicts[index];
            if (verdict.is_enabled && verdict.proxies().a == proxy) overlapping.push_back(verdict.bodies);
        }
        std::sort(overlapping.begin() + old_size, overlapping.end());
    }
    overlapping_is_stale = false;
}

}  // namespace ecods
