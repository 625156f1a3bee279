#include <bit>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/box_tree_walk.hpp"
#include "simd/dispatch.hpp"

namespace ecods {

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
    std::vector<ParentBlock> parents;
    dispatch<find_parents>(levels_, reach, 0U, parents);
    // Tries the blocks around the center first, and then all blocks with the same parents.
    constexpr std::uint32_t all_children = (1u << width) - 1;
    for (const std::uint32_t beside : {0u, all_children}) {
        for (const ParentBlock& parent : parents) {
            for (std::uint32_t leaves = parent.children | beside; leaves != 0; leaves &= leaves - 1) {
                const std::uint32_t leaf = parent.block * width + static_cast<std::uint32_t>(std::countr_zero(leaves));
                if (!take_hole(leaf, item.slot, position)) continue;
                set(position, line);
                return true;
            }
        }
    }
    return false;
}

}  // namespace ecods
