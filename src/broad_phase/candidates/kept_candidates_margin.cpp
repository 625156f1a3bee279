// Fat boxes: how much room a box gets, and where.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

constexpr double back = 0.125;  // room for turning back, as a share of the room ahead

// How many escaped boxes ahead memory is asked for.
constexpr std::size_t prefetch_distance = 6;

double share_behind(const KeptCandidates::Habits& habits, std::size_t axis) noexcept {
    return habits.turns[axis] || habits.direction[axis] == 0 ? 0.5 : back / (1 + back);
}

// Enlarges `fat` by the room that there was around a box, turned to where that one went.
void turn_room(const PackedBox& packed_box, const PackedBox& old_line, const KeptCandidates::Habits& habits,
               double limit, Aabb& fat) noexcept {
    const KeyBox box = key_box(packed_box);
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
bool is_about_to_escape(const PackedBox& line, const PackedBox& fat_line,
                        const KeptCandidates::Habits& habits) noexcept {
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
PackedBox KeptCandidates::fatten(const Escaped& escaped, const Aabb& box) noexcept {
    const double largest = (box.max - box.min).maxCoeff();
    const double room = 0.5 * (largest < mean_extent_ ? mean_extent_ : largest);
    if (!(room <= std::numeric_limits<double>::max())) return lines_[escaped.slot];
    Vec3 down, up;  // how far each side moved out
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        down[k] = double_of(escaped.before.ends[axis]) - box.min[k];
        up[k] = box.max[k] - double_of(~escaped.before.ends[axis + 4]);
    }
    Aabb fat = box;
    Habits& habits = habits_[escaped.slot];
    const PackedBox& old_line = fat_lines_[escaped.slot];
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
    PackedBox line;
    make_packed_box(fat, line);
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
        const PackedBox fat = fatten(escaped, box);
        const PackedBox old = std::exchange(fat_lines_[slot], fat);
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
        make_packed_box(fat, fat_lines_[slot]);
        enlarge(fat_lines_[slot], lines_[slot]);
    }
}

}  // namespace ecods
