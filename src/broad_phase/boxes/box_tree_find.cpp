#include <bit>

#include "bounds/ball_bounds.hpp"
#include "bounds/segment_bounds.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/box_tree_walk.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Appends to `found` the slots of the boxes in the given lanes of a block on level 0, as walk_one() requires of its
// result.
class SlotResult {
  public:
    ECODS_ALWAYS_INLINE SlotResult(const std::vector<SlotIndex>& slots, std::vector<SlotIndex>& found)
        : slots_(slots), found_(found) {}

    ECODS_ALWAYS_INLINE bool operator()(const TreeNode& node, std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            found_.push_back(
                slots_[node.block * BoxBlock::width + static_cast<std::uint32_t>(std::countr_zero(lanes))]);
        }
        return true;
    }

  private:
    const std::vector<SlotIndex>& slots_;
    std::vector<SlotIndex>& found_;
};

// Implements BoxTree::find for a box.
ECODS_ALWAYS_INLINE std::uint64_t find_slots(const BoxLevels& levels, const std::vector<SlotIndex>& slots,
                                             const BoxReach& reach, std::vector<SlotIndex>& found) {
    const LevelsView<0> view(levels);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += BoxBlock::width;
        return overlapping(view.block(node), reach);
    };
    LevelsView<0>::Stack stack;
    walk_one(view, stack, bound, SlotResult(slots, found));
    return tests;
}

}  // namespace

void BoxTree::prefetch(std::size_t position) const noexcept {
    prefetch_block(levels_[0][position / BoxBlock::width]);
    if (levels_.size() > 1) prefetch_block(levels_[1][position / BoxBlock::width / BoxBlock::width]);
}

std::uint64_t BoxTree::find(const BoxReach& reach, std::vector<SlotIndex>& found) const {
    return dispatch<find_slots>(levels_, slots_, reach, found);
}

template <class Bounds>
std::uint64_t BoxTree::find(const Bounds& bounds, std::vector<SlotIndex>& found) const {
    const LevelsView<0> view(levels_);
    PackedBox around;
    make_packed_box(bounds.box(), around);
    BoxReach reach;
    make_reach(around, reach);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += BoxBlock::width;
        std::uint32_t lanes = overlapping(view.block(node), reach);
        for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            if (bounds.judge(box_of(view.block(node).get(lane))) == BoxVerdict::apart) lanes ^= rest & -rest;
        }
        return lanes;
    };
    LevelsView<0>::Stack stack;
    walk_one(view, stack, bound, SlotResult(slots_, found));
    return tests;
}
template std::uint64_t BoxTree::find(const SegmentBounds&, std::vector<SlotIndex>&) const;
template std::uint64_t BoxTree::find(const BallBounds&, std::vector<SlotIndex>&) const;

}  // namespace ecods
