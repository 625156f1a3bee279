#include <algorithm>
#include <iterator>

#include "world/world_impl.hpp"

namespace ecods {
namespace {

// An update is quick where nothing changed, so lists are merged only when there is something to merge.
void add_sorted(std::vector<BodyPair>& list, const std::vector<BodyPair>& more) {
    if (more.empty()) return;
    std::vector<BodyPair> result;
    result.reserve(list.size() + more.size());
    std::ranges::merge(list, more, std::back_inserter(result));
    list.swap(result);
}

void remove_sorted(std::vector<BodyPair>& list, const std::vector<BodyPair>& gone) {
    if (gone.empty()) return;
    std::vector<BodyPair> result;
    result.reserve(list.size());
    std::ranges::set_difference(list, gone, std::back_inserter(result));
    list.swap(result);
}

}  // namespace

void World::update() {
    Impl& w = *impl_;
    const bool is_idle = w.changed.empty() && !w.candidates_are_dirty && !w.update_failed;
    if (is_idle) {
        w.began.clear();
        w.ended.clear();
        w.statistics.cache_hits += w.verdicts.size();
    } else {
        w.update_failed = true;  // until the end is reached
        w.take_over_candidates();
        w.test_changed_pairs();
        w.commit();
        w.update_failed = false;
    }
    ++w.statistics.updates;
}

// Brings the cache to the pairs that the broad phase has now. What ended goes first: where a body's slot was used
// again, the same pair of slots may end and begin.
void World::Impl::take_over_candidates() {
    broad_phase->update();
    for (const ProxyPair pair : broad_phase->ended()) {
        const Verdict verdict = verdicts.remove(pair);
        if (verdict.colliding) lost.push_back(verdict.bodies);
    }
    for (const ProxyPair pair : broad_phase->began()) verdicts.add(pair, ids_of(pair));
    candidates_are_dirty = false;
}

// Every pair of which a body changed, once. A pair that began has a body that changed.
void World::Impl::test_changed_pairs() {
    tested.clear();
    for (const ProxyIndex proxy : changed) {
        for (const ProxyIndex partner : verdicts.partners(proxy)) {
            if (slots[partner].is_changed && partner < proxy) continue;
            const ProxyPair pair{std::min(proxy, partner), std::max(proxy, partner)};
            tested.push_back({pair, test(pair, memory)});
        }
    }
}

void World::Impl::commit() {
    statistics.moved_bodies += static_cast<std::uint64_t>(
        std::ranges::count_if(changed, [&](ProxyIndex proxy) { return slots[proxy].is_alive(); }));
    statistics.two_body_tests += tested.size();
    statistics.cache_hits += verdicts.size() - tested.size();
    commit_candidates();
    commit_verdicts();
    for (const ProxyIndex proxy : changed) slots[proxy].is_changed = false;
    changed.clear();
}

void World::Impl::commit_candidates() {
    overlapping.clear();
    overlapping.reserve(broad_phase->pairs().size());
    for (const ProxyPair pair : broad_phase->pairs()) overlapping.push_back(ids_of(pair));
}

void World::Impl::commit_verdicts() {
    began.clear();
    ended.swap(lost);
    lost.clear();
    for (const TestedPair& t : tested) {
        Verdict& verdict = verdicts.at(t.pair);
        if (verdict.colliding == t.colliding) continue;
        verdict.colliding = t.colliding;
        (t.colliding ? began : ended).push_back(verdict.bodies);
    }
    std::ranges::sort(began);
    std::ranges::sort(ended);
    remove_sorted(colliding, ended);
    add_sorted(colliding, began);
    // A pair that lost its box overlap and found it again while updates failed has both ended and begun: it went on.
    std::vector<BodyPair> both;
    std::ranges::set_intersection(began, ended, std::back_inserter(both));
    remove_sorted(began, both);
    remove_sorted(ended, both);
}

}  // namespace ecods
