// Margins: how far a fat box reaches beyond its box, and to which sides.
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

// Makes fat boxes, and remembers of each slot how its box moved. Any fat box that contains its box is right; how fat it
// is is a matter of speed.
class Margins {
  public:
    static constexpr double widest = 0.75;         // of margins, as a share of the extent
    static constexpr std::uint32_t steps_min = 2;  // one that lasts for fewer is not worth its candidates

    MovingFrame& frame() noexcept { return frame_; }
    const MovingFrame& frame() const noexcept { return frame_; }
    Lookahead& lookahead() noexcept { return lookahead_; }
    const Lookahead& lookahead() const noexcept { return lookahead_; }

    void reserve(std::size_t count) { hints_.reserve(count); }
    void begin_update() noexcept { ++update_number_; }
    void add(SlotIndex slot);  // nothing is known of its box
    void reorder(std::span<const SlotIndex> order) { reorder_values(hints_, order); }
    void set_mean_extent(double extent) noexcept { mean_extent_ = extent; }

    // A fat box for one that escaped, which is `box` now, and `line` packed. `fat` is the fat box that it left.
    PackedBox fat_box(const EscapedBox& escaped, const Aabb& box, const PackedBox& line, const PackedBox& fat) noexcept;

    // Whether a box has used up half of its margin, and `fat` is another fat box for it: what would escape before
    // others do would be looked up alone, or ask for another search of everything.
    bool renew(SlotIndex slot, const Aabb& box, const PackedBox& line, PackedBox& fat) const noexcept;

    // Learns which directions boxes often turn in, say because they lie in one layer, from the moves of so many boxes.
    void learn_turns(std::size_t awake_count) noexcept;

    std::size_t bytes() const noexcept;

  private:
    // How a box moved when it last escaped, by axis, and when that was.
    struct MotionHint {
        std::uint32_t up : 3 = 0, down : 3 = 0;  // a bit for each axis; none of the two: not known
        std::uint32_t turns : 3 = 0;
        std::uint32_t escaped_at : 23 = 0;  // the last digits of the number of the update
    };

    struct Axes;
    static constexpr std::uint32_t all_axes = 7;

    MovingFrame frame_;
    Lookahead lookahead_;
    std::vector<MotionHint> hints_;  // by slot
    double mean_extent_ = 0;
    std::uint32_t update_number_ = 0;
    std::array<std::uint64_t, 3> turn_counts_{};
    std::uint32_t common_turns_ = 0;  // axes along which boxes often turn
};

}  // namespace ecods
