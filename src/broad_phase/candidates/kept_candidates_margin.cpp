// Margins: how far a fat box reaches beyond its box, and to which sides.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

constexpr double back = 0.125;  // the margin behind, for turning back, as a share of the margin ahead

// Of boxes that move together, as a share of the extent, for what each does beside that.
constexpr double common_motion_margin = 0x1p-7;

// A margin that lasts for fewer steps is not worth its candidates.
constexpr std::uint32_t steps_min = 2;

// How many escaped boxes ahead memory is asked for.
constexpr std::size_t prefetch_distance = 6;

double share_behind(const KeptCandidates::MotionHint& hint, std::size_t axis) noexcept {
    return hint.turns[axis] || hint.direction[axis] == 0 ? 0.5 : back / (1 + back);
}

// Enlarges `fat` by the margin that a box had, shifted towards the side that the box went to.
void turn_margin(const PackedBox& packed_box, const PackedBox& old_line, const KeptCandidates::MotionHint& hint,
                 double limit, Aabb& fat) noexcept {
    const KeyBox box = key_box(packed_box);
    const KeyBox old = key_box(old_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const double margin = (double_of(box.min[axis]) - double_of(old.min[axis])) +
                              (double_of(old.max[axis]) - double_of(box.max[axis]));
        if (!(margin > 0)) continue;
        const double behind = share_behind(hint, axis);
        const double low = hint.direction[axis] > 0 ? behind : 1 - behind;
        fat.min[k] -= std::min(limit, low * margin);
        fat.max[k] += std::min(limit, (1 - low) * margin);
    }
}

// Whether the margin ahead is nearly used up.
bool is_about_to_escape(const PackedBox& line, const PackedBox& fat_line,
                        const KeptCandidates::MotionHint& hint) noexcept {
    constexpr double left = 0.125;
    const KeyBox box = key_box(line);
    const KeyBox fat = key_box(fat_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (hint.direction[axis] == 0) continue;
        const double low = double_of(box.min[axis]) - double_of(fat.min[axis]);
        const double high = double_of(fat.max[axis]) - double_of(box.max[axis]);
        const double ahead = hint.direction[axis] > 0 ? high : low;
        if (ahead < left * (low + high)) return true;
    }
    return false;
}

}  // namespace

// The box of a slot as fat boxes are.
PackedBox KeptCandidates::line_in_frame(SlotIndex slot, const Aabb& box) const noexcept {
    if (frame_.is_at_origin()) return lines_[slot];
    PackedBox line;
    make_packed_box(frame_.of(box), line);
    return line;
}

// The margin is `lookahead_` more steps like the last one, and some for turning back. It is at most half an extent, so
// that a fast box does not collect candidates that it will not meet. A longer step was a jump, after which the next one
// is not known; then the box gets the margin that it had before, in the direction that it went. None is given to a box
// that would leave it within some steps, or that jumps time after time: to find candidates that it will not meet costs
// more than to look it up again.
PackedBox KeptCandidates::fatten(const Escaped& escaped, const Aabb& box) noexcept {
    const double largest = (box.max - box.min).maxCoeff();
    const double margin_max = 0.5 * (largest < mean_extent_ ? mean_extent_ : largest);
    const PackedBox here_line = line_in_frame(escaped.slot, box);
    if (!(margin_max <= std::numeric_limits<double>::max())) return here_line;
    const Vec3 went = frame_.went();
    Vec3 down, up;  // how far each side moved out
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        down[k] = double_of(escaped.before.ends[axis]) - box.min[k] + went[k];
        up[k] = box.max[k] - double_of(~escaped.before.ends[axis + 4]) - went[k];
    }
    Aabb fat = frame_.of(box);
    if (frame_.is_moving()) {
        fat.min.array() -= common_motion_margin * largest;
        fat.max.array() += common_motion_margin * largest;
    }
    MotionHint& hint = motion_hints_[escaped.slot];
    const std::uint32_t lasted = update_number_ - std::exchange(hint.escaped_at, update_number_);
    const PackedBox& old_line = fat_lines_[escaped.slot];
    const double step = std::max(down.cwiseAbs().maxCoeff(), up.cwiseAbs().maxCoeff());
    if (steps_min * step > margin_max && (step <= margin_max || lasted <= steps_min)) return here_line;
    if (step <= margin_max) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (down[k] == up[k]) continue;
            const std::int8_t direction = up[k] > down[k] ? 1 : -1;
            // What turned before its margin was used up will turn again, as what lies between two others does.
            if (direction == -hint.direction[k]) {
                hint.turns[k] = true;
                ++turn_counts_[k];
            }
            hint.direction[k] = direction;
            const double behind = hint.turns[k] || is_turning_common_[k] ? 1 : back;
            fat.min[k] -= std::min(margin_max, lookahead_ * std::max(down[k], -behind * down[k]));
            fat.max[k] += std::min(margin_max, lookahead_ * std::max(up[k], -behind * up[k]));
        }
    } else if (!old_line.is_empty()) {
        turn_margin(packed_box(key_box(frame_.of_before(box_of(escaped.before)))), old_line, hint, margin_max, fat);
    }
    // Rounding, in whatever direction, must not leave the box outside.
    PackedBox line;
    make_packed_box(fat, line);
    enlarge(line, here_line);
    return line;
}

void KeptCandidates::prefetch(SlotIndex slot) const noexcept {
    __builtin_prefetch(&proxies_[slot]);
    __builtin_prefetch(&lines_[slot]);
    __builtin_prefetch(&fat_lines_[slot]);
    __builtin_prefetch(&old_fat_lines_[slot], 1);
    __builtin_prefetch(&motion_hints_[slot], 1);
}

// Gives the escaped boxes their new fat boxes. Returns those that are far from where they were, or new: in their old
// place in the forest, they would stretch the bounds around it.
std::vector<BoxForest::Item> KeptCandidates::fatten_escaped(const ProxyTable& table) {
    std::vector<BoxForest::Item> unsorted;
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
        if (old.is_empty() || !overlap(old, fat)) unsorted.push_back(BoxForest::make_item(frame_.of(box), slot));
    }
    return unsorted;
}

// Which directions boxes often turn in, say because they lie in one layer. A margin behind all of them costs about as
// much as a search for one in this many of them in each update.
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
        const Aabb& box = table.boxes()[proxies_[slot]];
        const PackedBox line = line_in_frame(slot, box);
        if (!is_about_to_escape(line, fat_lines_[slot], motion_hints_[slot])) continue;
        Aabb fat = frame_.of(box);
        turn_margin(line, fat_lines_[slot], motion_hints_[slot], std::numeric_limits<double>::infinity(), fat);
        old_fat_lines_[slot] = fat_lines_[slot];
        set_flag(slot, searching);
        make_packed_box(fat, fat_lines_[slot]);
        enlarge(fat_lines_[slot], line);
    }
}

}  // namespace ecods
