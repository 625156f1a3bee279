#include <bit>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/box_tree_walk.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Refers to the levels and slots of a tree.
struct TreeView {
    const BoxLevels& levels;
    const std::vector<SlotIndex>& slots;
};

// Implements BoxTree::join. For a tree with itself, each pair is appended once.
ECODS_ALWAYS_INLINE std::uint64_t join_trees(const TreeView& tree, const TreeView& other,
                                             std::vector<std::array<SlotIndex, 2>>& found) {
    const bool is_self = &tree.levels == &other.levels;
    const bool is_one_block = other.levels.size() == 1;
    std::uint64_t tests = 0;
    std::vector<ParentBlock> parents;
    BoxReach reach;
    for (std::uint32_t own = 0; own < tree.levels[0].size(); ++own) {
        const BoxBlock& block = tree.levels[0][own];
        const PackedBox bounds = block.bounds();
        if (bounds.is_empty()) continue;
        make_reach(bounds, reach);
        parents.clear();
        if (is_one_block) {
            parents.push_back({0, 1});
        } else {
            tests += find_parents(other.levels, reach, is_self ? own : 0, parents);
        }
        for (std::uint32_t lane = 0; lane < BoxBlock::width; ++lane) {
            const PackedBox line = block.get(lane);
            if (line.is_empty()) continue;
            const SlotIndex slot = tree.slots[own * BoxBlock::width + lane];
            make_reach(line, reach);
            for (const ParentBlock& parent : parents) {
                std::uint32_t leaves = parent.children;
                if (!is_one_block) {
                    leaves &= overlapping(other.levels[1][parent.block], reach);
                    tests += BoxBlock::width;
                }
                for (; leaves != 0; leaves &= leaves - 1) {
                    const std::uint32_t leaf =
                        parent.block * BoxBlock::width + static_cast<std::uint32_t>(std::countr_zero(leaves));
                    std::uint32_t bits = overlapping(other.levels[0][leaf], reach);
                    tests += BoxBlock::width;
                    if (is_self && leaf == own) bits &= ~std::uint32_t{1} << lane;
                    for (; bits != 0; bits &= bits - 1) {
                        const auto partner = static_cast<std::uint32_t>(std::countr_zero(bits));
                        found.push_back({slot, other.slots[leaf * BoxBlock::width + partner]});
                    }
                }
            }
        }
    }
    return tests;
}

}  // namespace

std::uint64_t BoxTree::join(const BoxTree& other, std::vector<std::array<SlotIndex, 2>>& found) const {
    return dispatch<join_trees>(TreeView{levels_, slots_}, TreeView{other.levels_, other.slots_}, found);
}

}  // namespace ecods
