// The candidates of boxes that awoke, came, or left their fat boxes.
#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/candidates/kept_candidates_loops.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// How many escaped boxes ahead memory is asked for.
constexpr std::size_t prefetch_distance = 6;

}  // namespace

// Whether the two were a candidate before fat boxes changed, if one of them was awake.
bool KeptCandidates::were_candidates(SlotIndex a, SlotIndex b) const noexcept {
    const PackedBox& fat_a = has_flag(a, searching) ? old_fat_lines_[a] : fat_lines_[a];
    const PackedBox& fat_b = has_flag(b, searching) ? old_fat_lines_[b] : fat_lines_[b];
    BoxReach reach;
    make_reach(fat_a, reach);
    return overlaps(fat_b, reach);
}

std::size_t KeptCandidates::count_asleep(std::span<const ProxyIndex> proxies) const noexcept {
    if (awake_count_ == used_count_) return 0;
    return static_cast<std::size_t>(std::count_if(proxies.begin(), proxies.end(),
                                                  [&](ProxyIndex proxy) { return !has_flag(slots_[proxy], awake); }));
}

// Before boxes move: the candidates of those that do.
void KeptCandidates::wake(std::span<const ProxyIndex> proxies, Update& update) {
    if (awake_count_ == used_count_ && proxies.size() == used_count_) return;
    std::vector<SlotIndex> woken;
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = slots_[proxy];
        if (!has_flag(slot, awake)) woken.push_back(slot);
        set_flag(slot, moved);
    }
    if (!woken.empty()) refresh_forest(update.table);
    BoxReach reach;
    for (const SlotIndex slot : woken) {
        make_reach(fat_lines_[slot], reach);
        found_.clear();
        update.counts.box_tests += forest_.find(reach, found_);
        make_reach(lines_[slot], reach);
        for (const SlotIndex partner : found_) {
            if (partner == slot || has_flag(partner, awake)) continue;
            candidates_.push_back({slot, partner | (overlaps(lines_[partner], reach) ? overlap_bit : 0)});
        }
        set_flag(slot, awake);
    }
    awake_count_ += woken.size();
}

void KeptCandidates::search_escaped(std::span<const BoxForest::Item> unsorted, Update& update) {
    for (const BoxForest::Item& each : unsorted) forest_.remove(each.item.slot);
    if (is_forest_behind_) {
        for (const BoxForest::Item& each : unsorted) forest_lacks_.push_back(each.item.slot);
        refresh_forest(update.table);
    } else {
        for (std::size_t i = 0; i < escaped_.size(); ++i) {
            if (i + prefetch_distance < escaped_.size()) forest_.prefetch(escaped_[i + prefetch_distance].slot);
            forest_.set(escaped_[i].slot, fat_lines_[escaped_[i].slot]);
        }
        forest_.add(unsorted, fat_lines_);
    }
    for (std::size_t i = 0; i < escaped_.size(); ++i) {
        if (i + prefetch_distance < escaped_.size()) forest_.prefetch(escaped_[i + prefetch_distance].slot);
        link(escaped_[i].slot, update);
    }
    for (const Escaped& escaped : escaped_) {
        clear_flag(escaped.slot, searching);
        if (has_flag(escaped.slot, changed)) continue;
        set_flag(escaped.slot, changed);
        changed_slots_.push_back(escaped.slot);
    }
}

// Adds the candidates of a box with a new fat box. What is known of those that it had is right already, and one that is
// new and overlaps did not do so before: it would have been a candidate.
void KeptCandidates::link(SlotIndex slot, Update& update) {
    BoxReach reach;
    make_reach(fat_lines_[slot], reach);
    found_.clear();
    const std::uint64_t tests = forest_.find(reach, found_) + found_.size();
    update.counts.box_tests += tests;
    if (!overlaps(old_fat_lines_[slot], reach)) jump_tests_ += tests;
    for (const SlotIndex partner : found_) {
        __builtin_prefetch(&fat_lines_[partner]);
        __builtin_prefetch(&lines_[partner]);
    }
    make_reach(lines_[slot], reach);
    for (const SlotIndex partner : found_) {
        // Of two that escaped, the first does it.
        if (partner == slot || (has_flag(partner, searching) && partner < slot)) continue;
        if (were_candidates(slot, partner)) continue;
        const bool now = overlaps(lines_[partner], reach);
        if (now) update.began.push_back(ordered_pair(proxies_[slot], proxies_[partner]));
        if (has_flag(slot, awake) || has_flag(partner, awake)) {
            candidates_.push_back({slot, partner | (now ? overlap_bit : 0)});
        }
    }
}

// Before a search for everything: puts neighbours beside each other where they are not, or leaves the forest behind.
void KeptCandidates::order_slots(std::span<const BoxForest::Item> unsorted, const ProxyTable& table, bool must_sort) {
    // Boxes drift away from those that they are beside in memory, and those that came are beside any.
    escaped_since_sort_ += escaped_.size();
    const auto came_count =
        static_cast<std::size_t>(std::count_if(unsorted.begin(), unsorted.end(), [&](const BoxForest::Item& each) {
            return old_fat_lines_[each.item.slot].is_empty();
        }));
    const bool many_came = 8 * came_count > table.size();
    constexpr std::size_t escapes_per_sort = 8;
    if (must_sort || many_came || escaped_since_sort_ > escapes_per_sort * table.size()) {
        sort_slots(table);
    } else {
        for (const BoxForest::Item& each : unsorted) {
            forest_.remove(each.item.slot);
            forest_lacks_.push_back(each.item.slot);
        }
        is_forest_behind_ = true;
    }
}

void KeptCandidates::search_all(std::span<const BoxForest::Item> unsorted, bool must_sort, Update& update) {
    fatten_used_up(update.table);
    order_slots(unsorted, update.table, must_sort);
    candidates_.clear();
    update.counts.box_tests += search_.find_pairs(fat_lines_, candidates_) + candidates_.size();
    dispatch<Loops::take_found>(*this, update);
    for (std::uint8_t& flags : flags_) flags &= static_cast<std::uint8_t>(~(searching | changed));
    changed_slots_.clear();
}

// Puts everything that is kept by slot in the order in which the search goes through boxes.
void KeptCandidates::sort_slots(const ProxyTable& table) {
    double sum = 0;
    for (SlotIndex slot = 0; slot < proxies_.size(); ++slot) {
        if (lines_[slot].is_empty()) continue;
        const Aabb& box = table.boxes()[proxies_[slot]];
        const double extent = (box.max - box.min).maxCoeff();
        if (extent < std::numeric_limits<double>::max()) sum += extent / static_cast<double>(table.size());
    }
    mean_extent_ = sum;
    std::vector<SlotIndex> order;
    order.reserve(table.size());
    search_.append_order(fat_lines_, order);

    const auto reorder = [&order](auto& values) {
        std::remove_reference_t<decltype(values)> ordered(order.size());
        for (SlotIndex slot = 0; slot < order.size(); ++slot) ordered[slot] = values[order[slot]];
        values = std::move(ordered);
    };
    reorder(lines_);
    reorder(fat_lines_);
    reorder(old_fat_lines_);
    reorder(proxies_);
    reorder(flags_);
    reorder(motion_hints_);
    for (SlotIndex slot = 0; slot < order.size(); ++slot) slots_[proxies_[slot]] = slot;
    free_slots_.clear();
    searched_since_sort_ = escaped_since_sort_ = 0;
    forest_lacks_.clear();
    is_forest_behind_ = is_forest_renumbered_ = true;
}

// Makes the forest that of the fat boxes that are there now, before few are looked up.
void KeptCandidates::refresh_forest(const ProxyTable& table) {
    if (!is_forest_behind_) return;
    std::vector<BoxForest::Item> items;
    const auto add_item = [&](SlotIndex slot) {
        if (!lines_[slot].is_empty())
            items.push_back(BoxForest::make_item(frame_.of(table.boxes()[proxies_[slot]]), slot));
    };
    if (is_forest_renumbered_) {
        for (SlotIndex slot = 0; slot < lines_.size(); ++slot) add_item(slot);
        forest_.build(items, fat_lines_);
    } else {
        std::sort(forest_lacks_.begin(), forest_lacks_.end());
        forest_lacks_.erase(std::unique(forest_lacks_.begin(), forest_lacks_.end()), forest_lacks_.end());
        for (const SlotIndex slot : forest_lacks_) add_item(slot);
        forest_.refit(fat_lines_);
        forest_.add(items, fat_lines_);
    }
    forest_lacks_.clear();
    is_forest_behind_ = is_forest_renumbered_ = false;
}

}  // namespace ecods
