#include <bit>

#include "bounds/ball_bounds.hpp"
#include "bounds/segment_bounds.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "bvh/walk_one.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

ECODS_ALWAYS_INLINE void prefetch_block(const BoxBlock& block) noexcept {
    for (const auto& row : block.ends) __builtin_prefetch(row.data());
}

constexpr std::uint32_t width = BoxBlock::width;

// A block: on level 0 of boxes, on others of bounds of blocks.
struct TreeNode {
    std::uint32_t level;
    std::uint32_t block;
};

// What a walk sees of a tree: its blocks from the root down to level `bottom`.
template <std::uint32_t bottom>
class LevelsView {
  public:
    using Node = TreeNode;
    // A node has at most eight children, of which all but one wait while that one is followed down: with 2^32 boxes
    // there are eleven levels.
    static constexpr std::size_t stack_size = 11 * (width - 1) + 1;

    ECODS_ALWAYS_INLINE explicit LevelsView(const std::vector<std::vector<BoxBlock>>& levels) : levels_(levels) {}

    ECODS_ALWAYS_INLINE Node root() const noexcept { return {static_cast<std::uint32_t>(levels_.size() - 1), 0}; }
    ECODS_ALWAYS_INLINE bool is_bottom(const Node& node) const noexcept { return node.level == bottom; }
    ECODS_ALWAYS_INLINE const BoxBlock& block(const Node& node) const noexcept {
        return levels_[node.level][node.block];
    }
    ECODS_ALWAYS_INLINE Node child(const Node& node, std::uint32_t lane) const noexcept {
        const Node child{node.level - 1, node.block * width + lane};
        if constexpr (bottom == 0) prefetch_block(block(child));
        return child;
    }

  private:
    const std::vector<std::vector<BoxBlock>>& levels_;
};

// Appends the slots of the lanes of blocks of boxes.
class SlotResult {
  public:
    ECODS_ALWAYS_INLINE SlotResult(const std::vector<SlotIndex>& slots, std::vector<SlotIndex>& found)
        : slots_(slots), found_(found) {}

    ECODS_ALWAYS_INLINE bool operator()(const TreeNode& node, std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            found_.push_back(slots_[node.block * width + static_cast<std::uint32_t>(std::countr_zero(lanes))]);
        }
        return true;
    }

  private:
    const std::vector<SlotIndex>& slots_;
    std::vector<SlotIndex>& found_;
};

}  // namespace

void BoxTree::prefetch(std::size_t position) const noexcept {
    prefetch_block(levels_[0][position / width]);
    if (levels_.size() > 1) prefetch_block(levels_[1][position / width / width]);
}

ECODS_ALWAYS_INLINE std::uint64_t BoxTree::find_wide(const BoxReach& reach, std::vector<SlotIndex>& found) const {
    const LevelsView<0> view(levels_);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += width;
        return overlapping(view.block(node), reach);
    };
    walk_one(view, bound, SlotResult(slots_, found));
    return tests;
}

std::uint64_t BoxTree::find(const BoxReach& reach, std::vector<SlotIndex>& found) const {
    return dispatch<&BoxTree::find_wide>(*this, reach, found);
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
        tests += width;
        std::uint32_t lanes = overlapping(view.block(node), reach);
        for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            if (bounds.judge(box_of(view.block(node).get(lane))) == BoxVerdict::apart) lanes ^= rest & -rest;
        }
        return lanes;
    };
    walk_one(view, bound, SlotResult(slots_, found));
    return tests;
}
template std::uint64_t BoxTree::find(const SegmentBounds&, std::vector<SlotIndex>&) const;
template std::uint64_t BoxTree::find(const BallBounds&, std::vector<SlotIndex>&) const;

// The blocks of bounds on level 1, with the children, from `first` on, whose bounds overlap. Not of a single block.
ECODS_ALWAYS_INLINE std::uint64_t BoxTree::find_parents(const BoxReach& reach, std::uint32_t first,
                                                        std::vector<Parent>& found) const {
    const LevelsView<1> view(levels_);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += width;
        std::uint32_t lanes = overlapping(view.block(node), reach);
        // The first child that has a block from `first` on below it: it holds 8^(level - 1) blocks.
        const std::uint32_t begin = first >> (3 * (node.level - 1)), child = node.block * width;
        if (child < begin) lanes &= begin - child < width ? ~std::uint32_t{0} << (begin - child) : 0;
        return lanes;
    };
    const auto result = [&](const TreeNode& node, std::uint32_t lanes) {
        if (lanes != 0) found.push_back({node.block, lanes});
        return true;
    };
    walk_one(view, bound, result);
    return tests;
}

bool BoxTree::take_hole(std::uint32_t block, SlotIndex slot, std::uint32_t& position) noexcept {
    for (position = block * width; position < (block + 1) * width && position < size(); ++position) {
        if (slots_[position] != no_slot) continue;
        slots_[position] = slot;
        ++alive_count_;
        return true;
    }
    return false;
}

bool BoxTree::insert(const TreeItem& item, const PackedBox& line, std::uint32_t& position) {
    if (alive_count_ == size() || levels_.size() == 1) return false;
    const Vec3 center(item.center[0], item.center[1], item.center[2]);
    PackedBox point;
    make_packed_box({.min = center, .max = center}, point);
    BoxReach reach;
    make_reach(point, reach);
    std::vector<Parent> parents;
    dispatch<&BoxTree::find_parents>(*this, reach, 0U, parents);
    for (const Parent& parent : parents) {
        for (std::uint32_t leaves = parent.children; leaves != 0; leaves &= leaves - 1) {
            const std::uint32_t leaf = parent.block * width + static_cast<std::uint32_t>(std::countr_zero(leaves));
            if (!take_hole(leaf, item.slot, position)) continue;
            set(position, line);
            return true;
        }
    }
    for (const Parent& parent : parents) {
        for (std::uint32_t leaf = parent.block * width; leaf < (parent.block + 1) * width; ++leaf) {
            if (!take_hole(leaf, item.slot, position)) continue;
            set(position, line);
            return true;
        }
    }
    return false;
}

ECODS_ALWAYS_INLINE std::uint64_t BoxTree::join_wide(const BoxTree& other,
                                                     std::vector<std::array<SlotIndex, 2>>& found) const {
    const bool is_self = this == &other;
    const bool is_one_block = other.levels_.size() == 1;
    std::uint64_t tests = 0;
    std::vector<Parent> parents;
    BoxReach reach;
    for (std::uint32_t own = 0; own < levels_[0].size(); ++own) {
        const BoxBlock& block = levels_[0][own];
        const PackedBox bounds = block.bounds();
        if (bounds.is_empty()) continue;
        make_reach(bounds, reach);
        parents.clear();
        if (is_one_block) {
            parents.push_back({0, 1});
        } else {
            tests += other.find_parents(reach, is_self ? own : 0, parents);
        }
        for (std::uint32_t lane = 0; lane < width; ++lane) {
            const PackedBox line = block.get(lane);
            if (line.is_empty()) continue;
            const SlotIndex slot = slots_[own * width + lane];
            make_reach(line, reach);
            for (const Parent& parent : parents) {
                std::uint32_t leaves = parent.children;
                if (!is_one_block) {
                    leaves &= overlapping(other.levels_[1][parent.block], reach);
                    tests += width;
                }
                for (; leaves != 0; leaves &= leaves - 1) {
                    const std::uint32_t leaf =
                        parent.block * width + static_cast<std::uint32_t>(std::countr_zero(leaves));
                    std::uint32_t bits = overlapping(other.levels_[0][leaf], reach);
                    tests += width;
                    if (is_self && leaf == own) bits &= ~std::uint32_t{1} << lane;
                    for (; bits != 0; bits &= bits - 1) {
                        const auto partner = static_cast<std::uint32_t>(std::countr_zero(bits));
                        found.push_back({slot, other.slots_[leaf * width + partner]});
                    }
                }
            }
        }
    }
    return tests;
}

std::uint64_t BoxTree::join(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const {
    return dispatch<&BoxTree::join_wide>(*this, other, found);
}

}  // namespace ecods
