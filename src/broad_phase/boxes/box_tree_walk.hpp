// Shared parts of the walks of a BoxTree: a view of its levels, and the search for parents of blocks. All of it is
// always inlined, into functions that are compiled for each instruction set (simd/dispatch.hpp). Those functions take
// levels and slots and are no members, so that the class does not name them.
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

// A block: of boxes on level 0, of bounds of blocks on higher levels.
struct TreeNode {
    std::uint32_t level;
    std::uint32_t block;
};

// The view of a tree that walk_one needs: its blocks from the root down to level `bottom`.
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

// A block on level 1, and some of its lanes, as bits.
struct ParentBlock {
    std::uint32_t block;
    std::uint32_t children;
};

// Appends the blocks on level 1 that have overlapping lanes, with these lanes; only children from `first` on count.
// There must be more than one level. Returns the number of box tests.
ECODS_ALWAYS_INLINE std::uint64_t find_parents(const BoxLevels& levels, const BoxReach& reach, std::uint32_t first,
                                               std::vector<ParentBlock>& found) {
    constexpr std::uint32_t width = BoxBlock::width;
    const LevelsView<1> view(levels);
    std::uint64_t tests = 0;
    const auto bound = [&](const TreeNode& node) {
        tests += width;
        std::uint32_t lanes = overlapping(view.block(node), reach);
        // The first child with a block from `first` on below it; a child has 8^(level - 1) blocks.
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
