// Implements full searches: updates that find the pairs of all boxes at once. A full search compares the pairs that it
// finds with the previous pairs, and reads no kept candidates.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {

// Performs an update by a full search, which needs no data of earlier updates but the boxes. Also decides if boxes have
// margins from now on.
void KeptCandidates::replace_everything(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;
    const auto [forecast, common_step, lifetime_of_fast] = foresee(table, changes);
    const bool had_margins = std::exchange(has_margins_, keeping_.pays(forecast));
    if (has_margins_ && !changes.moved.empty()) margins_.lookahead().start(keeping_.lifetime(), lifetime_of_fast);
    for (const ProxyIndex proxy : changes.removed) {
        forest_.remove(slots_.slot_of(proxy));
        slots_.remove(slots_.slot_of(proxy));
    }
    drop_candidates();
    MovingFrame& frame = margins_.frame();
    if (!has_margins_) frame = {};
    frame.start(has_margins_ ? common_step : Vec3::Zero());
    if (has_margins_) {
        if (!had_margins) slots_.drop_margins();
        for (const ProxyIndex proxy : changes.moved) slots_.wake(slots_.slot_of(proxy));
        move(finding, true);
    } else {
        slots_.put_all_to_sleep();
        slots_.take(changes.moved, table);
    }
    for (const ProxyIndex proxy : changes.added) add(proxy, table);
    search_everything(table, false, counts);
    ++counts.rebuilds;
    if (has_margins_ && changes.moved.empty()) {
        margins_.lookahead().start(Lookahead::guess(pairs_.size(), slots_.used_count()));
        if (RebuildRule::are_many(changes.added.size(), table.size())) {
            forest_.refresh(slots_.fat_lines());  // otherwise, the first box to move or to come would wait for it
        }
    }
}

void KeptCandidates::fatten_escaped(const ProxyTable& table) {
    for (std::size_t i = 0; i < escaped_.size(); ++i) fattened_.came += fatten(i, table).is_empty() ? 1 : 0;
    fattened_.count += escaped_.size();
    escaped_.clear();
}

void KeptCandidates::drop_candidates() {
    candidates_.clear();
    slots_.forget_changes();
}

// Sets pairs_ to the pairs of boxes that overlap. If boxes have margins, first gives escaped boxes new fat boxes, and
// also sets the candidates, from the pairs of fat boxes.
void KeptCandidates::search_everything(const ProxyTable& table, bool must_sort, BroadPhaseCounts& counts) {
    std::vector<CandidateList::SlotPair>& found = candidates_.found();
    if (has_margins_) {
        fatten_everything(table, must_sort);
        const std::uint64_t tests = search_.find_pairs(slots_.fat_lines(), found) + found.size();
        counts.box_tests += tests;
        margins_.lookahead().note_everything(tests);
        candidates_.settle(slots_);
        const auto for_each = [&](const auto& visit) { candidates_.for_each_overlapping(slots_, visit); };
        list_each_pair(for_each, table.end(), pairs_, listing_);
        candidates_.drop_asleep(slots_);
        slots_.settle_all_escaped();
    } else {
        forest_.forget();
        counts.box_tests += search_.find_pairs(slots_.lines(), found) + found.size();
        for (auto& [a, b] : found) a = slots_.proxies()[a], b = slots_.proxies()[b];
        list_pairs(found, table.end(), pairs_, listing_);
        candidates_.clear();
    }
    keeping_.note_pairs(pairs_.size());
    escaped_.clear();
}

// Gives new fat boxes to the boxes that escaped or would escape soon. Then sorts the slots if `must_sort` is true, or
// if neighbours are no longer close in memory; otherwise leaves the forest stale.
void KeptCandidates::fatten_everything(const ProxyTable& table, bool must_sort) {
    fatten_escaped(table);
    Fattened fattened = std::exchange(fattened_, {});
    std::size_t renewed = fattened.count;
    for (SlotIndex slot = 0; slot < slots_.size(); ++slot) {
        if (!slots_.has(slot, SlotTable::awake) || slots_.has(slot, SlotTable::escaped)) continue;
        PackedBox fat = slots_.fat_lines()[slot];
        if (margins_.renew(slot, table.boxes()[slots_.proxies()[slot]], slots_.lines()[slot], fat)) {
            slots_.set_fat(slot, fat);
            ++renewed;
        }
    }
    rebuild_.note_everything(renewed, table.size());
    if (rebuild_.is_order_due(fattened.count, fattened.came, table.size()) || must_sort) {
        sort_slots(table);
    } else {
        forest_.leave_behind();
        forest_.add(fattened.far, slots_.fat_lines());
    }
}

// Renumbers the slots in the order in which the search goes through boxes, so that neighbours are close in memory, and
// updates the mean extent.
void KeptCandidates::sort_slots(const ProxyTable& table) {
    double sum = 0;
    for (SlotIndex slot = 0; slot < slots_.size(); ++slot) {
        if (slots_.is_free(slot)) continue;
        const Aabb& box = table.boxes()[slots_.proxies()[slot]];
        const double extent = (box.max - box.min).maxCoeff();
        if (extent < std::numeric_limits<double>::max()) sum += extent / static_cast<double>(table.size());
    }
    margins_.set_mean_extent(sum);
    std::vector<SlotIndex> order;
    order.reserve(table.size());
    search_.append_order(slots_.fat_lines(), order);
    slots_.reorder(order);
    margins_.reorder(order);
    rebuild_.note_order();
    forest_.forget();
}

}  // namespace ecods
