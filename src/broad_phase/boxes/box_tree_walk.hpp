// Provides the parts that the walks of a BoxTree share: a view of its levels, and the search for parents of blocks. The
// functions here are always inlined into functions that are compiled for each instruction set (simd/dispatch.hpp).
// Those functions are no members of BoxTree, and take the levels and slots of a tree as arguments, so that the class
// need not declare them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/packed_box.hpp"
#include "bvh/walks/walk_one.hpp"
#include "simd/inline.hpp"

namespace ecods {

ECODS_ALWAYS_INLINE void prefetch_block(const BoxBlock& block) noexcept {
    for (const auto& row : block.ends) __builtin_prefetch(row.data());
}

// Names a block: its level, and its index in the level.
struct TreeNode {
    std::uint32_t level;
    std::uint32_t block;
};

// Gives walk_one() the view of a tree that it needs: the blocks from the root down to level `bottom`.
template <std::uint32_t bottom>
class LevelsView {
  public:
    using Node = TreeNode;
    // A node has at most eight children, and seven wait while one is followed down. With 2^32 boxes there are eleven
    // levels.
    using Stack = FixedStack<Node, 11 * (BoxBlock::width - 1) + 1>;

    ECODS_ALWAYS_INLINE explicit LevelsView(const BoxLevels& levels) : levels_(levels) {}

    ECODS_ALWAYS_INLINE Node root() const noexcept { return {static_cast<std::uint32_t>(levels_.size() - 1), 0}; }
    ECODS_ALWAYS_INLINE bool is_bottom(const Node& node) const noexcept { return node.level == bottom; }
    ECODS_ALWAYS_INLINE const BoxBlock& block(const Node& node) const noexcept {
        return levels_[node.level][node.block];
    }
    ECODS_ALWAYS_INLINE Node child(const Node& node, std::uint32_t lane) const noexcept {
        const Node child{node.level - 1, node.block * BoxBlock::width + lane};
        if constexpr (bottom == 0) prefetch_block(block(child));
        return child;
    }

  private:
    const BoxLevels& levels_;
};

// Names a block on level 1 and some of its lanes, as bits.
struct ParentBlock {
    std::uint32_t block;
    std::uint32_t children;
};

// Appends to `found` each block on level 1 that has lanes which overlap the box of `reach`, together with these lanes.
// Only lanes whose block on level 0 is at least `first` count. Call only if there is more than one level. Returns the
// number of box tests.
ECODS_ALWAYS_INLINE std::uint64_t find_parents(const BoxLevels& levels, const BoxReach& reach, std::uint32_t first,
                                               std::vector<ParentBlock>& found) {
    constexpr std::uint32_t width = BoxBlock::width;
    const LevelsView<1> view(levels);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += width;
        std::uint32_t lanes = overlapping(view.block(node), reach);
        // A child of `node` contains 8^(level - 1) blocks of level 0. `begin` is the first child, on its level, that
        // contains block `first` or a later one.
        const std::uint32_t begin = first >> (3 * (node.level - 1)), child = node.block * width;
        if (child < begin) lanes &= begin - child < width ? ~std::uint32_t{0} << (begin - child) : 0;
        return lanes;
    };
    const auto result = [&](const TreeNode& node, std::uint32_t lanes) {
        if (lanes != 0) found.push_back({node.block, lanes});
        return true;
    };
    LevelsView<1>::Stack stack;
    walk_one(view, stack, bound, result);
    return tests;
}

}  // namespace ecods
