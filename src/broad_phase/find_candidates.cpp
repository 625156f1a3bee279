// Boxes that left their fat boxes: new fat boxes, and new candidates.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
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

void KeptCandidates::next_mark() {
    if (++mark_ == 0) {  // all numbers were used
        std::fill(marks_.begin(), marks_.end(), 0);
        mark_ = 1;
    }
}

void KeptCandidates::mark_overlapping(const CandidateLists& lists, SlotIndex slot) {
    next_mark();
    for (const std::uint32_t entry : lists.entries(slot)) {
        if (CandidateLists::overlaps(entry)) marks_[CandidateLists::slot_of(entry)] = mark_;
    }
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
        if (old.is_empty() || !overlap(old, fat)) newcomers.push_back(tree_item(box, slot));
    }
    return newcomers;
}

void KeptCandidates::search_escaped(std::span<const TreeItem> newcomers, Update& update) {
    for (const TreeItem& newcomer : newcomers) forest_.remove(newcomer.slot);
    for (const Escaped& escaped : escaped_) forest_.set(escaped.slot, fat_lines_[escaped.slot]);
    forest_.add(newcomers, fat_lines_);
    for (const Escaped& escaped : escaped_) link(escaped.slot, update);
}

// Brings the candidates of a box with a new fat box up to date. Those that it keeps are right already, and a partner
// that is new and overlaps did not do so before: it would have been a candidate.
void KeptCandidates::link(SlotIndex slot, Update& update) {
    next_mark();
    BoxReach reach;
    make_reach(fat_lines_[slot], reach);
    for (auto i = static_cast<std::uint32_t>(candidates_.entries(slot).size()); i-- > 0;) {
        const SlotIndex partner = CandidateLists::slot_of(candidates_.entries(slot)[i]);
        if (overlaps(fat_lines_[partner], reach)) {
            marks_[partner] = mark_;
        } else {
            candidates_.remove(slot, i);
        }
    }
    found_.clear();
    update.counts.box_tests += forest_.find(reach, found_);
    make_reach(lines_[slot], reach);
    for (const SlotIndex partner : found_) {
        if (is_marked(partner) || partner == slot) continue;
        const bool now = overlaps(lines_[partner], reach);
        candidates_.add(slot, partner, now);
        if (now) update.began.push_back(ordered_pair(proxies_[slot], proxies_[partner]));
    }
    update.counts.box_tests += found_.size();
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
    found_pairs_.clear();
    const std::uint64_t tests = forest_.find_pairs(found_pairs_) + found_pairs_.size();
    update.counts.box_tests += tests;
    // Boxes drift away from those that they are in a block with. Sorting costs about as much as half of the tests.
    const double tests_per_box = static_cast<double>(tests) / static_cast<double>(update.table.size() + 1);
    if (do_sort) tests_after_sort_ = tests_per_box;
    is_worn_ = tests_per_box > 1.25 * tests_after_sort_;
    relink_all(update);
}

// Makes the pairs that were found the candidates.
void KeptCandidates::relink_all(Update& update) {
    std::swap(old_candidates_, candidates_);
    candidates_.build(lines_.size(), found_pairs_);
    BoxReach reach;
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        const std::uint32_t count = candidates_.owned_count(slot);
        if (count == 0) continue;
        mark_overlapping(old_candidates_, slot);
        make_reach(lines_[slot], reach);
        const std::uint32_t* const entries = candidates_.entries(slot).data();
        for (std::uint32_t i = 0; i < count; ++i) {
            const SlotIndex partner = entries[i];
            if (!overlaps(lines_[partner], reach)) continue;
            candidates_.flip(slot, i);
            if (!is_marked(partner)) update.began.push_back(ordered_pair(proxies_[slot], proxies_[partner]));
        }
    }
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

    std::vector<BoxLine> lines(order.size()), fat_lines(order.size());
    std::vector<ProxyIndex> proxies(order.size());
    for (SlotIndex slot = 0; slot < order.size(); ++slot) {
        lines[slot] = lines_[order[slot]];
        fat_lines[slot] = fat_lines_[order[slot]];
        proxies[slot] = proxies_[order[slot]];
        slots_[proxies[slot]] = slot;
    }
    lines_ = std::move(lines);
    fat_lines_ = std::move(fat_lines);
    proxies_ = std::move(proxies);
    candidates_.renumber(order);
    flags_.assign(order.size(), 0);
    marks_.assign(order.size(), 0);
    mark_ = 0;
    free_slots_.clear();
    searched_since_sort_ = 0;
}

}  // namespace ecods
