// Boxes that left their fat boxes: new fat boxes, and new candidates.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "broad_phase/kept_candidates.hpp"

namespace ecods {

// Room for `horizon_` more steps like the last one, and some for turning back. No more than half an extent, so that
// what is fast does not collect candidates that it will not meet. A step that is longer than that was a jump and tells
// nothing; then half of the room that there was before it is kept, evenly.
BoxLine KeptCandidates::fatten(const Escaped& escaped, const Aabb& box) const noexcept {
    constexpr double back = 0.125;
    const double largest = (box.max - box.min).maxCoeff();
    const double room = 0.5 * (largest < mean_extent_ ? mean_extent_ : largest);
    if (!(room <= std::numeric_limits<double>::max())) return lines_[escaped.slot];
    const KeyBox before = key_box(escaped.before);
    Vec3 down, up;  // how far each side moved out
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        down[k] = double_of(before.min[axis]) - box.min[k];
        up[k] = box.max[k] - double_of(before.max[axis]);
    }
    Aabb fat = box;
    if (down.cwiseAbs().maxCoeff() <= room && up.cwiseAbs().maxCoeff() <= room) {
        fat.min -= (horizon_ * down.cwiseMax(-back * down)).cwiseMin(room);
        fat.max += (horizon_ * up.cwiseMax(-back * up)).cwiseMin(room);
    } else if (const BoxLine& old_line = fat_lines_[escaped.slot]; !old_line.is_empty()) {
        const KeyBox old = key_box(old_line);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            const double low = double_of(before.min[axis]) - double_of(old.min[axis]);
            const double high = double_of(old.max[axis]) - double_of(before.max[axis]);
            const double each = std::min(room, 0.25 * (low + high));
            if (!(each > 0)) continue;
            fat.min[k] -= each;
            fat.max[k] += each;
        }
    }
    // Rounding, in whatever direction, must not leave the box outside.
    BoxLine line;
    make_box_line(fat, line);
    enlarge(line, lines_[escaped.slot]);
    return line;
}

// Gives the escaped boxes their new fat boxes. Returns those that are far from where they were, or new: in their old
// place in the forest, they would stretch the bounds around it.
std::vector<TreeItem> KeptCandidates::fatten_escaped(const ProxyTable& table) {
    std::vector<TreeItem> newcomers;
    for (const Escaped& escaped : escaped_) {
        const SlotIndex slot = escaped.slot;
        const Aabb& box = table.boxes()[proxies_[slot]];
        const BoxLine fat = fatten(escaped, box);
        const BoxLine old = std::exchange(fat_lines_[slot], fat);
        old_fat_lines_[slot] = old;
        set_flag(slot, searching);
        if (old.is_empty() || !overlap(old, fat)) newcomers.push_back(tree_item(box, slot));
    }
    return newcomers;
}

// Whether the two were a candidate before fat boxes changed, if one of them was awake.
bool KeptCandidates::were_candidates(SlotIndex a, SlotIndex b) const noexcept {
    const BoxLine& fat_a = has_flag(a, searching) ? old_fat_lines_[a] : fat_lines_[a];
    const BoxLine& fat_b = has_flag(b, searching) ? old_fat_lines_[b] : fat_lines_[b];
    return overlap(fat_a, fat_b);
}

// Before boxes move: the candidates of those that do.
void KeptCandidates::wake(const std::vector<ProxyIndex>& proxies, Update& update) {
    if (awake_count_ == used_count_ && proxies.size() == used_count_) return;
    std::vector<SlotIndex> woken;
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = slots_[proxy];
        if (!has_flag(slot, awake)) woken.push_back(slot);
        set_flag(slot, moved);
    }
    if (8 * woken.size() > used_count_ + 64) {
        wake_all(update);
        return;
    }
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

void KeptCandidates::wake_all(Update& update) {
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        if (!lines_[slot].is_empty()) set_flag(slot, awake);
    }
    awake_count_ = used_count_;
    candidates_.clear();
    update.counts.box_tests += forest_.find_pairs(candidates_);
    ++update.counts.rebuilds;
    BoxReach reach;
    for (Candidate& candidate : candidates_) {
        make_reach(lines_[candidate[0]], reach);
        if (overlaps(lines_[candidate[1]], reach)) candidate[1] |= overlap_bit;
    }
}

void KeptCandidates::search_escaped(std::span<const TreeItem> newcomers, Update& update) {
    for (const TreeItem& newcomer : newcomers) forest_.remove(newcomer.slot);
    for (const Escaped& escaped : escaped_) forest_.set(escaped.slot, fat_lines_[escaped.slot]);
    forest_.add(newcomers, fat_lines_);
    for (const Escaped& escaped : escaped_) link(escaped.slot, update);
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
    update.counts.box_tests += forest_.find(reach, found_);
    update.counts.box_tests += found_.size();
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

void KeptCandidates::search_all(std::span<const TreeItem> newcomers, bool must_sort, Update& update) {
    const bool do_sort =
        must_sort || is_worn_ || 64 * (forest_.newcomer_count() + newcomers.size()) > update.table.size();
    if (do_sort) {
        sort_slots(update.table);
    } else {
        for (const TreeItem& newcomer : newcomers) forest_.remove(newcomer.slot);
        forest_.refit(fat_lines_);
        forest_.add(newcomers, fat_lines_);
    }
    candidates_.clear();
    const std::uint64_t tests = forest_.find_pairs(candidates_) + candidates_.size();
    update.counts.box_tests += tests;
    // Boxes drift away from those that they are in a block with. Sorting costs about as much as half of the tests.
    const double tests_per_box = static_cast<double>(tests) / static_cast<double>(update.table.size() + 1);
    if (do_sort) tests_after_sort_ = tests_per_box;
    is_worn_ = tests_per_box > 1.25 * tests_after_sort_;
    take_found(update);
    for (std::uint8_t& flags : flags_) flags &= static_cast<std::uint8_t>(~(searching | changed));
    changed_slots_.clear();
}

// Makes the pairs that were found the candidates.
void KeptCandidates::take_found(Update& update) {
    BoxReach reach;
    Candidate* write = candidates_.data();
    for (const Candidate candidate : candidates_) {
        const auto [a, b] = candidate;
        make_reach(lines_[a], reach);
        const bool now = overlaps(lines_[b], reach);
        if (now && !were_candidates(a, b)) update.began.push_back(ordered_pair(proxies_[a], proxies_[b]));
        if (!has_flag(a, awake) && !has_flag(b, awake)) continue;
        *write++ = {a, b | (now ? overlap_bit : 0)};
    }
    candidates_.resize(static_cast<std::size_t>(write - candidates_.data()));
}

// Plants the forest anew and puts everything that is kept by slot in its order.
void KeptCandidates::sort_slots(const ProxyTable& table) {
    std::vector<BoxForest::Item> items;
    items.reserve(table.size());
    double sum = 0;
    for (SlotIndex slot = 0; slot < proxies_.size(); ++slot) {
        if (lines_[slot].is_empty()) continue;
        const Aabb& box = table.boxes()[proxies_[slot]];
        items.push_back(BoxForest::make_item(box, slot));
        const double extent = (box.max - box.min).maxCoeff();
        if (extent < std::numeric_limits<double>::max()) sum += extent / static_cast<double>(table.size());
    }
    mean_extent_ = sum;
    forest_.build(items, fat_lines_);
    std::vector<SlotIndex> order;
    order.reserve(items.size());
    forest_.append_order(order);
    forest_.renumber();

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
    for (SlotIndex slot = 0; slot < order.size(); ++slot) slots_[proxies_[slot]] = slot;
    free_slots_.clear();
    searched_since_sort_ = 0;
}

}  // namespace ecods
