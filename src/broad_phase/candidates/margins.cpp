#include "broad_phase/candidates/margins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "broad_phase/boxes/packed_box.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

constexpr double back = 0.125;  // margin behind a box, for turning back, as a share of the margin ahead

// In a moving frame, each box gets a margin of this share of its extent for its motion relative to the frame.
constexpr double common_motion_margin = 0x1p-7;

// MotionHint stores numbers of updates modulo escape_numbers.
constexpr std::uint32_t escape_numbers = 1u << 23;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Holds the lower and upper ends of a box, one axis in each lane. The fourth lanes are zero at first; computations may
// change these lanes.
struct BoxEnds {
    using Doubles = Vec<double, 4>;
    Doubles low, high;
};

ECODS_ALWAYS_INLINE BoxEnds::Doubles first_three(BoxEnds::Doubles v) noexcept {
    return shuffle<0, 1, 2, 4>(v, BoxEnds::Doubles{});
}
ECODS_ALWAYS_INLINE BoxEnds::Doubles last_three(BoxEnds::Doubles v) noexcept {
    return shuffle<1, 2, 3, 4>(v, BoxEnds::Doubles{});
}
ECODS_ALWAYS_INLINE double largest_of(BoxEnds::Doubles v) noexcept {
    const double m = v[0] > v[1] ? v[0] : v[1];
    return m > v[2] ? m : v[2];
}

ECODS_ALWAYS_INLINE void find_ends(const Aabb& box, BoxEnds& ends) noexcept {
    static_assert(sizeof(Aabb) == 6 * sizeof(double));
    ends.low = first_three(load_anywhere<BoxEnds::Doubles>(box.min.data()));
    ends.high = last_three(load_anywhere<BoxEnds::Doubles>(box.min.data() + PackedBox::second));
}
ECODS_ALWAYS_INLINE void find_ends(const BoxLanes& box, BoxEnds& ends) noexcept {
    ends.low = first_three(doubles_of(box.first));
    ends.high = last_three(doubles_of(~box.second));
}
ECODS_ALWAYS_INLINE void find_ends(const PackedBox& line, BoxEnds& ends) noexcept {
    BoxLanes lanes;
    load_lanes(line, lanes);
    find_ends(lanes, ends);
}

// Sets `line` to the smallest box that contains both boxes: rounding of `ends`, in any mode, must not leave `other`
// outside.
ECODS_ALWAYS_INLINE void pack(const BoxEnds& ends, const BoxLanes& other, PackedBox& line) noexcept {
    const KeyLanes low = keys_of(bits_as<KeyLanes>(ends.low)), high = ~keys_of(bits_as<KeyLanes>(ends.high));
    store_lanes({min(shuffle<0, 1, 2, 4>(low, high), other.first), min(shuffle<2, 4, 5, 6>(low, high), other.second)},
                line);
}

}  // namespace

void Margins::add(SlotIndex slot) {
    if (hints_.size() <= slot) grow_to(hints_, std::size_t{slot} + 1);
    hints_[slot] = {};
}

// Axes computes margins on all axes at once, without branches on single axes, which would be unpredictable.
struct Margins::Axes {
    using Doubles = BoxEnds::Doubles;
    using Mask = MaskOf<Doubles>;

    ECODS_ALWAYS_INLINE static Mask mask_of(std::uint32_t axes) noexcept {
        return (Mask{1, 2, 4, 0} & broadcast<Mask>(axes)) != 0;
    }
    ECODS_ALWAYS_INLINE static std::uint32_t axes_of(Mask mask) noexcept {
        return static_cast<std::uint32_t>(any_bits(mask & Mask{1, 2, 4, 0}));
    }

    // Sets `here` to the box in the frame of the fat boxes.
    ECODS_ALWAYS_INLINE static void put_in_frame(const MovingFrame& frame, const Aabb& box, const PackedBox& line,
                                                 BoxLanes& here) noexcept {
        frame.is_at_origin() ? load_lanes(line, here) : make_lanes(frame.of(box), here);
    }

    // Enlarges `fat` by the margin that `box` had in `old`, by at most `limit` on each side. The larger part of the
    // margin is on the side to which the box moves.
    ECODS_ALWAYS_INLINE static void turn_margin(const BoxEnds& box, const BoxEnds& old, const MotionHint& hint,
                                                double limit, BoxEnds& fat) noexcept {
        const Doubles half = broadcast<Doubles>(0.5), small = broadcast<Doubles>(back / (1 + back)), none{};
        const Doubles margin = (box.low - old.low) + (old.high - box.high);
        const Doubles behind = mask_of(hint.turns | ~(hint.up | hint.down)) ? half : small;
        const Doubles low = mask_of(hint.up) ? behind : 1 - behind;
        const Doubles most = broadcast<Doubles>(limit);
        fat.low -= margin > none ? min(low * margin, most) : none;
        fat.high += margin > none ? min((1 - low) * margin, most) : none;
    }

    // Returns true if, on some axis, less than half of the margin is left ahead of the box.
    ECODS_ALWAYS_INLINE static bool is_about_to_escape(const BoxEnds& box, const BoxEnds& fat,
                                                       const MotionHint& hint) noexcept {
        constexpr double left = 0.5;
        const Doubles low = box.low - fat.low, high = fat.high - box.high;
        const Doubles ahead = mask_of(hint.up) ? high : low;
        return any(mask_of(hint.up | hint.down) & (ahead < left * (low + high)));
    }

    // Enlarges `fat` on each axis along which the box moved: ahead by the last step times the lookahead, and by less
    // behind, for turning back. Updates the hint.
    ECODS_ALWAYS_INLINE static void grow_ahead(Margins& margins, MotionHint& hint, Doubles down, Doubles up,
                                               double limit, BoxEnds& fat) noexcept {
        const Mask moved = down != up, goes_up = moved & (up > down), goes_down = moved & ~goes_up;
        const std::uint32_t ups = axes_of(goes_up), downs = axes_of(goes_down);
        // A box that turned before its margin was used up will turn again, as a box between two others does.
        const std::uint32_t turned = (ups & hint.down) | (downs & hint.up);
        hint.turns = (hint.turns | turned) & all_axes;
        for (std::size_t axis = 0; axis < 3; ++axis) margins.turn_counts_[axis] += turned >> axis & 1;
        hint.up = (hint.up | ups) & ~downs & all_axes;
        hint.down = (hint.down | downs) & ~ups & all_axes;
        const Doubles behind =
            mask_of(hint.turns | margins.common_turns_) ? broadcast<Doubles>(1) : broadcast<Doubles>(back);
        const double updates = margins.lookahead_.updates();
        const Doubles most = broadcast<Doubles>(limit), none{};
        fat.low -= moved ? min(updates * max(-behind * down, down), most) : none;
        fat.high += moved ? min(updates * max(-behind * up, up), most) : none;
    }

    ECODS_ALWAYS_INLINE static void fat_box(Margins& margins, const EscapedBox& escaped, const Aabb& box,
                                            const PackedBox& line, const PackedBox& old_fat,
                                            PackedBox& result) noexcept {
        const MovingFrame& frame = margins.frame_;
        BoxLanes here;
        put_in_frame(frame, box, line, here);
        store_lanes(here, result);
        BoxEnds now, before;
        find_ends(box, now);
        find_ends(escaped.before, before);
        const Doubles extent = now.high - now.low;
        if (!all(extent <= broadcast<Doubles>(std::numeric_limits<double>::max()))) return;
        const double largest = largest_of(extent);
        const double margin_max = widest * (largest < margins.mean_extent_ ? margins.mean_extent_ : largest);
        Doubles went{};
        if (frame.is_moving() || !frame.is_at_origin()) {
            const Vec3 by = frame.went();
            went = Doubles{by[0], by[1], by[2], 0};
        }
        const Doubles down = before.low - now.low + went, up = now.high - before.high - went;  // outward step of a side
        BoxEnds fat = now;
        if (!frame.is_at_origin()) find_ends(frame.of(box), fat);
        if (frame.is_moving()) {
            fat.low -= common_motion_margin * largest;
            fat.high += common_motion_margin * largest;
        }
        MotionHint& hint = margins.hints_[escaped.slot];
        const std::uint32_t lasted = (margins.update_number_ - hint.escaped_at) % escape_numbers;
        hint.escaped_at = margins.update_number_ % escape_numbers;
        const double step = largest_of(max(absolute(down), absolute(up)));
        if (steps_min * step > margin_max && (step <= margin_max || lasted <= steps_min)) return;
        if (step <= margin_max) {
            grow_ahead(margins, hint, down, up, margin_max, fat);
        } else if (!old_fat.is_empty()) {
            BoxEnds old;
            if (!frame.is_at_origin()) find_ends(frame.of_before(box_of(escaped.before)), before);
            find_ends(old_fat, old);
            turn_margin(before, old, hint, margin_max, fat);
        }
        pack(fat, here, result);
    }

    ECODS_ALWAYS_INLINE static bool renew(const Margins& margins, SlotIndex slot, const Aabb& box,
                                          const PackedBox& line, PackedBox& fat_line) noexcept {
        BoxLanes here;
        put_in_frame(margins.frame_, box, line, here);
        BoxEnds now, old;
        find_ends(here, now);
        find_ends(fat_line, old);
        const MotionHint& hint = margins.hints_[slot];
        if (!is_about_to_escape(now, old, hint)) return false;
        BoxEnds fat = now;
        turn_margin(now, old, hint, infinity, fat);
        pack(fat, here, fat_line);
        return true;
    }
};

// Gives a box a margin for as many more steps like the last one as the lookahead says, and a smaller margin behind, for
// turning back. The margin is at most `widest` times the extent of the box, or times the mean extent if that is larger,
// so that a fast box does not collect candidates that it will not meet. A longer step was a jump, after which the next
// step is unknown; then the box gets the margin that it had before, in the direction of its motion. A box gets no
// margin if it would leave the margin within some steps, or if it jumps time after time: finding candidates that it
// will not meet costs more than looking it up again.
PackedBox Margins::fat_box(const EscapedBox& escaped, const Aabb& box, const PackedBox& line,
                           const PackedBox& old_fat) noexcept {
    PackedBox result;
    dispatch<Axes::fat_box>(*this, escaped, box, line, old_fat, result);
    return result;
}

bool Margins::renew(SlotIndex slot, const Aabb& box, const PackedBox& line, PackedBox& fat_line) const noexcept {
    return dispatch<Axes::renew>(*this, slot, box, line, fat_line);
}

// Finds the axes along which more than one in `rare` moves turned. A margin behind all boxes costs about as much as a
// search for one box in `rare` in each update.
void Margins::learn_turns(std::size_t awake_count) noexcept {
    constexpr double rare = 512;
    const double moves = static_cast<double>(awake_count) * static_cast<double>(lookahead_.restart());
    common_turns_ = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if (rare * static_cast<double>(turn_counts_[axis]) > moves) common_turns_ |= 1u << axis;
    }
    turn_counts_ = {};
}

std::size_t Margins::bytes() const noexcept {
    return bytes_of(hints_);
}

}  // namespace ecods
