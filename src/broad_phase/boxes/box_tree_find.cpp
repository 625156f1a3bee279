#include <bit>

#include "simd/dispatch.hpp"
#include "broad_phase/boxes/box_tree.hpp"

namespace ecods {
namespace {

struct Node {
    std::uint32_t level;
    std::uint32_t block;
};

// A node has at most eight children, of which all but one wait while that one is followed down: with 2^32 boxes there
// are eleven levels.
using NodeStack = std::array<Node, 11 * 7 + 1>;

ECODS_ALWAYS_INLINE void prefetch_block(const BoxBlock& block) noexcept {
    for (const auto& row : block.ends) __builtin_prefetch(row.data());
}

}  // namespace

void BoxTree::prefetch(std::size_t position) const noexcept {
    prefetch_block(levels_[0][position / width]);
    if (levels_.size() > 1) prefetch_block(levels_[1][position / width / width]);
}

ECODS_ALWAYS_INLINE std::uint64_t BoxTree::find_wide(const BoxReach& reach, std::vector<SlotIndex>& found) const {
    std::uint64_t tests = 0;
    NodeStack stack;
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (depth > 0) {
        const Node node = stack[--depth];
        tests += width;
        for (std::uint32_t bits = overlapping(levels_[node.level][node.block], reach); bits != 0; bits &= bits - 1) {
            const std::uint32_t child = node.block * width + static_cast<std::uint32_t>(std::countr_zero(bits));
            if (node.level == 0) {
                found.push_back(slots_[child]);
            } else {
                stack[depth++] = {node.level - 1, child};
                prefetch_block(levels_[node.level - 1][child]);
            }
        }
    }
    return tests;
}

std::uint64_t BoxTree::find(const BoxReach& reach, std::vector<SlotIndex>& found) const {
    return dispatch<&BoxTree::find_wide>(*this, reach, found);
}

// The blocks of bounds on level 1, with the children, from `first` on, whose bounds overlap. Not of a single block.
ECODS_ALWAYS_INLINE std::uint64_t BoxTree::find_parents(const BoxReach& reach, std::uint32_t first,
                                                        std::vector<Parent>& found) const {
    std::uint64_t tests = 0;
    NodeStack stack;
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (depth > 0) {
        const Node node = stack[--depth];
        std::uint32_t bits = overlapping(levels_[node.level][node.block], reach);
        tests += width;
        const std::uint32_t child = node.block * width;
        if (node.level == 1) {
            if (child < first) bits &= first - child < width ? ~std::uint32_t{0} << (first - child) : 0;
            if (bits != 0) found.push_back({node.block, bits});
            continue;
        }
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t next = child + static_cast<std::uint32_t>(std::countr_zero(bits));
            // The last block of boxes below it.
            if (((std::uint64_t{next} + 1) << (3 * (node.level - 1))) <= first) continue;
            stack[depth++] = {node.level - 1, next};
        }
    }
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
    const Vec3 centre(item.centre[0], item.centre[1], item.centre[2]);
    PackedBox point;
    make_packed_box({.min = centre, .max = centre}, point);
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
