#include "broad_phase/candidates/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {
namespace {

constexpr double back = 0.125;  // the margin behind, for turning back, as a share of the margin ahead

// Of boxes that move together, as a share of the extent, for what each does beside that.
constexpr double common_motion_margin = 0x1p-7;

constexpr std::uint32_t all_axes = 7;

// Of the number of an update, so much is kept.
constexpr std::uint32_t escape_numbers = 1u << 23;

}  // namespace

void Margins::add(SlotIndex slot) {
    if (hints_.size() <= slot) grow_to(hints_, std::size_t{slot} + 1);
    hints_[slot] = {};
}

void Margins::reorder(std::span<const SlotIndex> order) {
    std::vector<MotionHint> ordered;
    ordered.reserve(order.size() + order.size() / 32);  // lest the first one that comes copies all
    ordered.resize(order.size());
    for (SlotIndex slot = 0; slot < order.size(); ++slot) ordered[slot] = hints_[order[slot]];
    hints_ = std::move(ordered);
}

// The box of a slot as fat boxes are.
PackedBox Margins::in_frame(const Aabb& box, const PackedBox& line) const noexcept {
    if (frame_.is_at_origin()) return line;
    PackedBox result;
    make_packed_box(frame_.of(box), result);
    return result;
}

double Margins::share_behind(const MotionHint& hint, std::size_t axis) noexcept {
    return MotionHint::has(hint.turns, axis) || !hint.knows(axis) ? 0.5 : back / (1 + back);
}

// Enlarges `fat` by the margin that a box had, shifted towards the side that the box went to.
void Margins::turn_margin(const PackedBox& line, const PackedBox& old_line, const MotionHint& hint, double limit,
                          Aabb& fat) noexcept {
    const KeyBox box = key_box(line);
    const KeyBox old = key_box(old_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        const double margin = (double_of(box.min[axis]) - double_of(old.min[axis])) +
                              (double_of(old.max[axis]) - double_of(box.max[axis]));
        if (!(margin > 0)) continue;
        const double behind = share_behind(hint, axis);
        const double low = MotionHint::has(hint.up, axis) ? behind : 1 - behind;
        fat.min[k] -= std::min(limit, low * margin);
        fat.max[k] += std::min(limit, (1 - low) * margin);
    }
}

// Whether half of the margin is used up.
bool Margins::is_about_to_escape(const PackedBox& line, const PackedBox& fat_line, const MotionHint& hint) noexcept {
    constexpr double left = 0.5;
    const KeyBox box = key_box(line);
    const KeyBox fat = key_box(fat_line);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!hint.knows(axis)) continue;
        const double low = double_of(box.min[axis]) - double_of(fat.min[axis]);
        const double high = double_of(fat.max[axis]) - double_of(box.max[axis]);
        const double ahead = MotionHint::has(hint.up, axis) ? high : low;
        if (ahead < left * (low + high)) return true;
    }
    return false;
}

// By the lookahead, where the last step moved a side out so far, and by less behind, for turning back.
void Margins::grow_ahead(MotionHint& hint, const Vec3& down, const Vec3& up, double limit, Aabb& fat) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        if (down[k] == up[k]) continue;
        const std::uint32_t bit = 1u << axis;
        const bool goes_up = up[k] > down[k];
        // What turned before its margin was used up will turn again, as what lies between two others does.
        if (((goes_up ? hint.down : hint.up) & bit) != 0) {
            hint.turns = (hint.turns | bit) & all_axes;
            ++turn_counts_[axis];
        }
        hint.up = (goes_up ? hint.up | bit : hint.up & ~bit) & all_axes;
        hint.down = (goes_up ? hint.down & ~bit : hint.down | bit) & all_axes;
        const double behind = MotionHint::has(hint.turns, axis) || is_turning_common_[axis] ? 1 : back;
        fat.min[k] -= std::min(limit, lookahead_.updates() * std::max(down[k], -behind * down[k]));
        fat.max[k] += std::min(limit, lookahead_.updates() * std::max(up[k], -behind * up[k]));
    }
}

// The margin is as many more steps like the last one as the lookahead says, and some for turning back. It is at most
// half an extent, so that a fast box does not collect candidates that it will not meet. A longer step was a jump, after
// which the next one is not known; then the box gets the margin that it had before, in the direction that it went. None
// is given to a box that would leave it within some steps, or that jumps time after time: to find candidates that it
// will not meet costs more than to look it up again.
PackedBox Margins::fat_box(const EscapedBox& escaped, const Aabb& box, const PackedBox& line,
                           const PackedBox& old_fat) noexcept {
    const double largest = (box.max - box.min).maxCoeff();
    const double margin_max = widest * (largest < mean_extent_ ? mean_extent_ : largest);
    const PackedBox here = in_frame(box, line);
    if (!(margin_max <= std::numeric_limits<double>::max())) return here;
    const Vec3 went = frame_.went();
    Vec3 down, up;  // how far each side moved out
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        down[k] = double_of(escaped.before.ends[axis]) - box.min[k] + went[k];
        up[k] = box.max[k] - double_of(~escaped.before.ends[axis + 3]) - went[k];
    }
    Aabb fat = frame_.of(box);
    if (frame_.is_moving()) {
        fat.min.array() -= common_motion_margin * largest;
        fat.max.array() += common_motion_margin * largest;
    }
    MotionHint& hint = hints_[escaped.slot];
    const std::uint32_t lasted = (update_number_ - hint.escaped_at) % escape_numbers;
    hint.escaped_at = update_number_ % escape_numbers;
    const double step = std::max(down.cwiseAbs().maxCoeff(), up.cwiseAbs().maxCoeff());
    if (steps_min * step > margin_max && (step <= margin_max || lasted <= steps_min)) return here;
    if (step <= margin_max) {
        grow_ahead(hint, down, up, margin_max, fat);
    } else if (!old_fat.is_empty()) {
        turn_margin(packed_box(key_box(frame_.of_before(box_of(escaped.before)))), old_fat, hint, margin_max, fat);
    }
    // Rounding, in whatever direction, must not leave the box outside.
    PackedBox result;
    make_packed_box(fat, result);
    enlarge(result, here);
    return result;
}

bool Margins::renew(SlotIndex slot, const Aabb& box, const PackedBox& line, PackedBox& fat_line) const noexcept {
    const PackedBox here = in_frame(box, line);
    if (!is_about_to_escape(here, fat_line, hints_[slot])) return false;
    Aabb fat = frame_.of(box);
    turn_margin(here, fat_line, hints_[slot], std::numeric_limits<double>::infinity(), fat);
    make_packed_box(fat, fat_line);
    enlarge(fat_line, here);
    return true;
}

// A margin behind all of them costs about as much as a search for one in this many of them in each update.
void Margins::learn_turns(std::size_t awake_count) noexcept {
    constexpr double rare = 512;
    const double moves = static_cast<double>(awake_count) * static_cast<double>(lookahead_.restart());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        is_turning_common_[axis] = rare * static_cast<double>(turn_counts_[axis]) > moves;
    }
    turn_counts_ = {};
}

std::size_t Margins::bytes() const noexcept {
    return bytes_of(hints_);
}

}  // namespace ecods
