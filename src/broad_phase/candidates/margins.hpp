// Defines margins: how far a fat box reaches beyond its box on each side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/candidates/lookahead.hpp"
#include "broad_phase/candidates/moving_frame.hpp"
#include "broad_phase/candidates/slot_table.hpp"

namespace ecods {

// Makes fat boxes, and stores for each slot how its box moved. Any fat box that contains its box gives right pairs; the
// size of the margin affects only the speed.
class Margins {
  public:
    static constexpr double widest = 0.75;         // widest margin, as a share of the extent
    static constexpr std::uint32_t steps_min = 2;  // a margin that lasts for fewer steps is not worth its candidates

    MovingFrame& frame() noexcept { return frame_; }
    const MovingFrame& frame() const noexcept { return frame_; }
    Lookahead& lookahead() noexcept { return lookahead_; }
    const Lookahead& lookahead() const noexcept { return lookahead_; }

    void reserve(std::size_t count) { hints_.reserve(count); }
    void begin_update() noexcept { ++update_number_; }
    void add(SlotIndex slot);  // with an unknown motion
    void reorder(std::span<const SlotIndex> order) { reorder_values(hints_, order); }
    void set_mean_extent(double extent) noexcept { mean_extent_ = extent; }

    // Returns a new fat box for an escaped box. `box` is the box as it is now, `line` the same box packed, and `fat`
    // the fat box that it left.
    PackedBox fat_box(const EscapedBox& escaped, const Aabb& box, const PackedBox& line, const PackedBox& fat) noexcept;

    // If a box has used up half of its margin, sets `fat` to a new fat box and returns true; otherwise returns false.
    // Without a new fat box, the box would soon escape alone, which takes a look-up or another full search.
    bool renew(SlotIndex slot, const Aabb& box, const PackedBox& line, PackedBox& fat) const noexcept;

    // Learns along which axes boxes often turn, for example because they lie in one layer. `awake_count` is the number
    // of boxes that move in an update.
    void learn_turns(std::size_t awake_count) noexcept;

    std::size_t bytes() const noexcept;

  private:
    // Stores how a box moved when it last escaped, by axis, and when that was.
    struct MotionHint {
        std::uint32_t up : 3 = 0, down : 3 = 0;  // a bit for each axis; the motion is unknown if neither has the bit
        std::uint32_t turns : 3 = 0;
        std::uint32_t escaped_at : 23 = 0;  // low bits of the number of the update
    };

    struct Axes;
    static constexpr std::uint32_t all_axes = 7;

    MovingFrame frame_;
    Lookahead lookahead_;
    std::vector<MotionHint> hints_;  // by slot
    double mean_extent_ = 0;
    std::uint32_t update_number_ = 0;
    std::array<std::uint64_t, 3> turn_counts_{};
    std::uint32_t common_turns_ = 0;  // axes along which boxes often turn, as bits
};

}  // namespace ecods
