// Finds the closest pairs of bodies, of all or of two groups.
#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "geometry/box_distance.hpp"
#include "query/intersection/asking.hpp"
#include "world/closest_search.hpp"
#include "world/enlarged.hpp"
#include "world/first_failure.hpp"
#include "world/pair_question.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Appends the bodies of two groups to a and b; the smaller group becomes a.
void find_members(const Bodies& bodies, const GroupPair& groups, std::vector<ProxyIndex>& a,
                  std::vector<ProxyIndex>& b) {
    a.clear();
    b.clear();
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        const Slot& slot = bodies[proxy];
        if (!slot.is_alive()) continue;
        if ((slot.filter.groups & groups.a) != 0) a.push_back(proxy);
        if ((slot.filter.groups & groups.b) != 0) b.push_back(proxy);
    }
    if (b.size() < a.size()) a.swap(b);
}

// Offers all pairs of two short lists of bodies to the search, pairs with the closest boxes first.
void offer_few(ClosestSearch& search, const Bodies& bodies, const OverlapTracker& boxes, ClosestMemory::Lists& lists) {
    auto& candidates = lists.candidates;
    candidates.clear();
    const double bound = search.bound();
    for (const ProxyIndex a : lists.members_a) {
        const Aabb& box = boxes.box(a);
        for (const ProxyIndex b : lists.members_b) {
            if (a == b) continue;
            const double lower = distance_below(box, boxes.box(b));
            if (lower <= bound) candidates.push_back({lower, ordered_pair(a, b)});
        }
    }
    std::ranges::sort(candidates, {},
                      [](const ClosestMemory::Candidate& c) { return std::tuple(key_of(c.lower), c.pair); });
    for (const auto& [lower, pair] : candidates) {
        if (lower > search.bound()) break;
        if (search.may_win(pair, lower) && bodies.is_enabled(pair)) search.offer(pair);
    }
}

// Offers to the search the pairs of two long lists of bodies that may be close enough: visits, for each body of the
// smaller group, the boxes near this body.
void offer_many(ClosestSearch& search, const Bodies& bodies, const OverlapTracker& boxes, const GroupPair& groups,
                std::span<const ProxyIndex> members) {
    for (const ProxyIndex a : members) {
        boxes.visit_near(boxes.box(a), search.bound(), [&](ProxyIndex b) {
            const ProxyPair pair = ordered_pair(a, b);
            const bool counts = a != b && groups.hold(bodies[a].filter, bodies[b].filter) && bodies.is_enabled(pair);
            return counts ? search.offer(pair) : search.bound();
        });
    }
}

}  // namespace

std::optional<ClosestPair> World::Impl::find_closest(double max_distance, const GroupPair& groups,
                                                     const Ask& ask) const {
    constexpr std::size_t few = 4096;  // number of pairs; if there are more, a tree finds the closest boxes sooner
    require_distance(max_distance);
    require_answers(Question::within);
    require_answers(Question::distance);
    Asking asking(ask);
    ClosestMemory& hints = ClosestMemory::of(asking.memory());
    ClosestSearch search(bodies, tests, broad_phase, max_distance, asking.memory());
    BodyPair& last = hints.last_of(groups);
    if (bodies.is_alive(last.a) && bodies.is_alive(last.b)) {
        const ProxyPair pair = ordered_pair(last.a.slot - 1, last.b.slot - 1);
        if (pair.a != pair.b && groups.hold(bodies[pair.a].filter, bodies[pair.b].filter) && bodies.is_enabled(pair)) {
            search.offer(pair);
        }
    }
    if (groups.are_all()) {
        broad_phase.visit_near_pairs(search.bound(), [&](ProxyPair pair) {
            return bodies.is_enabled(pair) ? search.offer(pair) : search.bound();
        });
    } else {
        ClosestMemory::Lists lists = std::exchange(hints.lists, {});
        find_members(bodies, groups, lists.members_a, lists.members_b);
        if (lists.members_a.size() * lists.members_b.size() <= few) {
            offer_few(search, bodies, broad_phase, lists);
        } else {
            offer_many(search, bodies, broad_phase, groups, lists.members_a);
        }
        hints.lists = std::move(lists);
    }
    const auto found = search.answer();
    if (found) last = found->bodies;
    return found;
}

ProxyPairs World::Impl::near_pairs_of(double max_distance, const GroupPair& groups) const {
    std::vector<ProxyIndex> chosen, others;
    std::vector<Aabb> enlarged_boxes;
    ProxyPairs pairs;
    find_members(bodies, groups, chosen, others);
    for (const ProxyIndex proxy : chosen) enlarged_boxes.push_back(enlarged(broad_phase.box(proxy), max_distance));
    if (groups.are_all()) {
        broad_phase.find_pairs_among(chosen, enlarged_boxes, pairs);
    } else {
        // The boxes of the smaller group are enlarged by the whole distance, because the boxes of the other group are
        // not.
        for (Aabb& box : enlarged_boxes) box = enlarged(box, max_distance);
        broad_phase.find_pairs_with(chosen, enlarged_boxes, pairs);
    }
    std::erase_if(pairs, [&](const ProxyPair& pair) {
        return !groups.hold(bodies[pair.a].filter, bodies[pair.b].filter) || !bodies.is_enabled(pair) ||
               distance_below(broad_phase.box(pair.a), broad_phase.box(pair.b)) > max_distance;
    });
    return pairs;
}

std::vector<ClosestPair> World::Impl::find_close(double max_distance, const GroupPair& groups, const Ask& ask) const {
    require_distance(max_distance);
    require_answers(Question::within);
    require_answers(Question::distance);
    const ProxyPairs pairs = near_pairs_of(max_distance, groups);
    std::vector<std::optional<ClosestPair>> found(pairs.size());
    FirstFailure failure;
    workers.run_question(pairs.size(), ask, [&](std::size_t at, QueryMemory& memory) {
        try {
            PairWitness witness;
            const Ask in_memory(memory, witness);
            const PairQuestion asked(bodies, tests, pairs[at]);
            if (asked.is_within(max_distance, in_memory)) found[at] = asked.find(in_memory);
        } catch (...) {
            failure.keep(bodies.ids_of(pairs[at]), std::current_exception());
        }
    });
    failure.rethrow();
    std::vector<const ClosestPair*> order;
    for (const auto& pair : found) {
        if (pair) order.push_back(&*pair);
    }
    std::ranges::sort(order, {},
                      [](const ClosestPair* pair) { return std::pair(key_of(pair->distance), pair->bodies); });
    std::vector<ClosestPair> result;
    result.reserve(order.size());
    for (const ClosestPair* const pair : order) result.push_back(*pair);
    return result;
}

std::optional<ClosestPair> World::closest_pair(double max_distance, const Ask& ask) const {
    const Impl& w = impl();
    return w.traced<calls::ClosestOfAll>(ask, w.find_closest(max_distance, {}, ask), max_distance);
}

std::optional<ClosestPair> World::closest_pair(double max_distance, std::uint64_t groups_a, std::uint64_t groups_b,
                                               const Ask& ask) const {
    const Impl& w = impl();
    const auto groups = std::minmax(groups_a, groups_b);
    return w.traced<calls::ClosestOfGroups>(ask, w.find_closest(max_distance, {groups.first, groups.second}, ask),
                                            max_distance, groups_a, groups_b);
}

std::vector<ClosestPair> World::closest_pairs(double max_distance, const Ask& ask) const {
    return closest_pairs(max_distance, GroupPair::all, GroupPair::all, ask);
}

std::vector<ClosestPair> World::closest_pairs(double max_distance, std::uint64_t groups_a, std::uint64_t groups_b,
                                              const Ask& ask) const {
    const Impl& w = impl();
    return w.traced<calls::ClosestPairs>(ask, w.find_close(max_distance, {groups_a, groups_b}, ask), max_distance,
                                         groups_a, groups_b);
}

}  // namespace ecods
