// Boxes that left their fat boxes: new fat boxes, and new candidates.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "base/dispatch.hpp"
#include "broad_phase/kept_candidates.hpp"

namespace ecods {

namespace {

constexpr double back = 0.125;  // room for turning back, as a share of the room ahead

// How many escaped boxes ahead memory is asked for.
constexpr std::size_t prefetch_distance = 6;

double share_behind(const KeptCandidates::Habits& habits, std::size_t axis) noexcept {
    return habits.turns[axis] || habits.direction[axis] == 0 ? 0.5 : back / (1 + back);
}

// Enlarges `fat` by the room that there was around a box, turned to where that one went.
void turn_room(const BoxLine& box_line, const BoxLine& old_line, const KeptCandidates::Habits& habits, double limit,
               Aabb& fat) noexcept {
    const KeyBox box = key_box(box_line);
    const KeyBox old = key_box(old_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const double room = (double_of(box.min[axis]) - double_of(old.min[axis])) +
                            (double_of(old.max[axis]) - double_of(box.max[axis]));
        if (!(room > 0)) continue;
        const double behind = share_behind(habits, axis);
        const double low = habits.direction[axis] > 0 ? behind : 1 - behind;
        fat.min[k] -= std::min(limit, low * room);
        fat.max[k] += std::min(limit, (1 - low) * room);
    }
}

// Whether the room ahead is nearly used up.
bool is_about_to_escape(const BoxLine& line, const BoxLine& fat_line, const KeptCandidates::Habits& habits) noexcept {
    constexpr double left = 0.125;
    const KeyBox box = key_box(line);
    const KeyBox fat = key_box(fat_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (habits.direction[axis] == 0) continue;
        const double low = double_of(box.min[axis]) - double_of(fat.min[axis]);
        const double high = double_of(fat.max[axis]) - double_of(box.max[axis]);
        const double ahead = habits.direction[axis] > 0 ? high : low;
        if (ahead < left * (low + high)) return true;
    }
    return false;
}

}  // namespace

// Room for `horizon_` more steps like the last one, and some for turning back. No more than half an extent, so that
// what is fast does not collect candidates that it will not meet. A step that is longer than that was a jump and tells
// nothing; then it gets the room that it had before, in the direction that it went.
BoxLine KeptCandidates::fatten(const Escaped& escaped, const Aabb& box) noexcept {
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
    Habits& habits = habits_[escaped.slot];
    const BoxLine& old_line = fat_lines_[escaped.slot];
    if (down.cwiseAbs().maxCoeff() <= room && up.cwiseAbs().maxCoeff() <= room) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (down[k] == up[k]) continue;
            const std::int8_t direction = up[k] > down[k] ? 1 : -1;
            // What turned before its room was used up will turn again, as what lies between two others does.
            if (direction == -habits.direction[k]) {
                habits.turns[k] = true;
                ++turn_counts_[k];
            }
            habits.direction[k] = direction;
            const double behind = habits.turns[k] || is_turning_common_[k] ? 1 : back;
            fat.min[k] -= std::min(room, horizon_ * std::max(down[k], -behind * down[k]));
            fat.max[k] += std::min(room, horizon_ * std::max(up[k], -behind * up[k]));
        }
    } else if (!old_line.is_empty()) {
        turn_room(escaped.before, old_line, habits, room, fat);
    }
    // Rounding, in whatever direction, must not leave the box outside.
    BoxLine line;
    make_box_line(fat, line);
    enlarge(line, lines_[escaped.slot]);
    return line;
}

void KeptCandidates::prefetch(SlotIndex slot) const noexcept {
    __builtin_prefetch(&proxies_[slot]);
    __builtin_prefetch(&lines_[slot]);
    __builtin_prefetch(&fat_lines_[slot]);
    __builtin_prefetch(&old_fat_lines_[slot], 1);
    __builtin_prefetch(&habits_[slot], 1);
}

// Gives the escaped boxes their new fat boxes. Returns those that are far from where they were, or new: in their old
// place in the forest, they would stretch the bounds around it.
std::vector<BoxForest::Item> KeptCandidates::fatten_escaped(const ProxyTable& table) {
    std::vector<BoxForest::Item> newcomers;
    for (std::size_t i = 0; i < escaped_.size(); ++i) {
        if (i + 2 * prefetch_distance < escaped_.size()) prefetch(escaped_[i + 2 * prefetch_distance].slot);
        if (i + prefetch_distance < escaped_.size()) {
            __builtin_prefetch(&table.boxes()[proxies_[escaped_[i + prefetch_distance].slot]]);
        }
        const Escaped& escaped = escaped_[i];
        const SlotIndex slot = escaped.slot;
        const Aabb& box = table.boxes()[proxies_[slot]];
        const BoxLine fat = fatten(escaped, box);
        const BoxLine old = std::exchange(fat_lines_[slot], fat);
        old_fat_lines_[slot] = old;
        set_flag(slot, searching);
        if (old.is_empty() || !overlap(old, fat)) newcomers.push_back(BoxForest::make_item(box, slot));
    }
    return newcomers;
}

// Which directions boxes often turn in, say because they lie in one layer. Room behind all of them costs about as much
// as a search for one in this many of them in each update.
void KeptCandidates::learn_turns() {
    constexpr double rare = 512;
    const double moves = static_cast<double>(awake_count_) * static_cast<double>(updates_since_search_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        is_turning_common_[axis] = rare * static_cast<double>(turn_counts_[axis]) > moves;
    }
    turn_counts_ = {};
    updates_since_search_ = 0;
}

// Of those that are still in their fat boxes: what would escape soon would ask for another rebuild then.
void KeptCandidates::fatten_used_up(const ProxyTable& table) {
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        if (!has_flag(slot, awake) || has_flag(slot, searching)) continue;
        if (!is_about_to_escape(lines_[slot], fat_lines_[slot], habits_[slot])) continue;
        Aabb fat = table.boxes()[proxies_[slot]];
        turn_room(lines_[slot], fat_lines_[slot], habits_[slot], std::numeric_limits<double>::infinity(), fat);
        old_fat_lines_[slot] = fat_lines_[slot];
        set_flag(slot, searching);
        make_box_line(fat, fat_lines_[slot]);
        enlarge(fat_lines_[slot], lines_[slot]);
    }
}

// Whether the two were a candidate before fat boxes changed, if one of them was awake.
bool KeptCandidates::were_candidates(SlotIndex a, SlotIndex b) const noexcept {
    const BoxLine& fat_a = has_flag(a, searching) ? old_fat_lines_[a] : fat_lines_[a];
    const BoxLine& fat_b = has_flag(b, searching) ? old_fat_lines_[b] : fat_lines_[b];
    BoxReach reach;
    make_reach(fat_a, reach);
    return overlaps(fat_b, reach);
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

void KeptCandidates::search_escaped(std::span<const BoxForest::Item> newcomers, Update& update) {
    for (const BoxForest::Item& newcomer : newcomers) forest_.remove(newcomer.item.slot);
    for (std::size_t i = 0; i < escaped_.size(); ++i) {
        if (i + prefetch_distance < escaped_.size()) forest_.prefetch(escaped_[i + prefetch_distance].slot);
        forest_.set(escaped_[i].slot, fat_lines_[escaped_[i].slot]);
    }
    forest_.add(newcomers, fat_lines_);
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

void KeptCandidates::search_all(std::span<const BoxForest::Item> newcomers, bool must_sort, Update& update) {
    fatten_used_up(update.table);
    const bool do_sort = must_sort || is_worn_ || 64 * forest_.newcomer_count() > update.table.size() ||
                         8 * newcomers.size() > update.table.size();
    if (do_sort) {
        sort_slots(update.table);
    } else {
        for (const BoxForest::Item& newcomer : newcomers) forest_.remove(newcomer.item.slot);
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
ECODS_FOR_EACH_INSTRUCTION_SET
void KeptCandidates::take_found(Update& update) {
    BoxReach reach;
    Candidate* write = candidates_.data();
    for (const Candidate candidate : candidates_) {
        const auto [a, b] = candidate;
        make_reach(lines_[a], reach);
        const bool now = overlaps(lines_[b], reach);
        // Most that overlap did so before: no branch on `now` alone, which could not be foretold.
        make_reach(has_flag(a, searching) ? old_fat_lines_[a] : fat_lines_[a], reach);
        const bool before = overlaps(has_flag(b, searching) ? old_fat_lines_[b] : fat_lines_[b], reach);
        if (now & !before) [[unlikely]] {
            update.began.push_back(ordered_pair(proxies_[a], proxies_[b]));
        }
        *write = {a, b | (static_cast<SlotIndex>(now) * overlap_bit)};
        write += ((flags_[a] | flags_[b]) & awake) != 0 ? 1 : 0;
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
    reorder(habits_);
    for (SlotIndex slot = 0; slot < order.size(); ++slot) slots_[proxies_[slot]] = slot;
    free_slots_.clear();
    searched_since_sort_ = 0;
}

}  // namespace ecods
