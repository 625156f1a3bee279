#include "broad_phase/boxes/along_walk.hpp"

#include <algorithm>
#include <limits>

#include "broad_phase/boxes/tree_parts.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using Numbers = Vec<double, 4>;

// double_of() of each lane.
ECODS_ALWAYS_INLINE Numbers numbers_of(KeyLanes keys) noexcept {
    const KeyLanes signs = keys < 0;
    return bits_as<Numbers>(((keys ^ signs) - signs) | (signs & std::numeric_limits<std::int64_t>::min()));
}

// MovingBox::meets_from for four lanes, step by step as it is there.
ECODS_ALWAYS_INLINE Numbers meet_lanes(const BoxBlock& block, std::size_t first, const MovingBox& moving) noexcept {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Numbers none = broadcast<Numbers>(0), gap_min = broadcast<Numbers>(MovingBox::gap_min);
    const Numbers number_max = broadcast<Numbers>(MovingBox::number_max);
    Numbers from = none, to = broadcast<Numbers>(infinity);
    KeyLanes never = lanes(&block.ends[0][first]) == PackedBox::unreachable;
    const KeyLanes present = ~never;
    for (std::size_t i = 0; i < 6; ++i) {
        const MovingBox::Side& side = moving.sides()[i];
        if (side.course == MovingBox::Course::without_end) continue;
        // Of an empty box any number does; the key of a negative is the negative, and ~k is -k - 1.
        const KeyLanes ends = lanes(&block.ends[i][first]) & present;
        const KeyLanes keys = i < 3 ? ends : ends + 1;
        if (side.course == MovingBox::Course::coming) {
            const Numbers gap = numbers_of(keys) - side.end;
            const Numbers counted = select(gap >= gap_min, min(gap, number_max), none);
            from = max(from, counted * side.factor);
            continue;
        }
        never |= keys > side.key;
        if (side.course == MovingBox::Course::going) {
            const Numbers room = max(side.end - numbers_of(keys), gap_min);
            to = min(to, max(room * side.factor, broadcast<Numbers>(MovingBox::time_min)));
        }
    }
    return select(never | (from > to), broadcast<Numbers>(infinity), min(from, number_max));
}

ECODS_ALWAYS_INLINE void meet_all_lanes(const BoxBlock& block, const MovingBox& moving, double* from) noexcept {
    static_assert(BoxBlock::width == 8);
    store(from, meet_lanes(block, 0, moving));
    store(from + 4, meet_lanes(block, 4, moving));
}

}  // namespace

void meet_block(const BoxBlock& block, const MovingBox& moving, std::array<double, BoxBlock::width>& from) {
    alignas(64) double lanes[BoxBlock::width];
    dispatch<meet_all_lanes>(block, moving, &lanes[0]);
    std::ranges::copy(lanes, from.begin());
}

std::uint64_t walk_along(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving,
                         double limit, const std::function<double(SlotIndex)>& visit) {
    constexpr std::uint32_t width = BoxBlock::width;
    Waiting<NearPart> waiting;
    for (const Part& root : Parts(trees, boxes).roots()) waiting.push({0, root});
    alignas(64) double from[width];
    std::uint64_t tests = 0;
    while (waiting.has_below(limit)) {
        const Part part = waiting.pop().part;
        if (part.is_box()) {
            limit = std::min(limit, visit(part.index));
            continue;
        }
        const BoxTree& tree = trees[part.tree];
        dispatch<meet_all_lanes>(tree.block(part.height - 1, part.index), moving, &from[0]);
        tests += width;
        for (std::uint32_t lane = 0; lane < width; ++lane) {
            if (!(from[lane] <= limit) || from[lane] > MovingBox::number_max) continue;
            const std::uint32_t child = part.index * width + lane;
            if (part.height > 1) {
                waiting.push({from[lane], {part.height - 1, child, part.tree}});
                continue;
            }
            // The tree's box contains that of the slot.
            const SlotIndex slot = tree.slot(child);
            const double own = moving.meets_from(boxes[slot]);
            ++tests;
            if (own <= limit && own <= MovingBox::number_max) waiting.push({own, {0, slot, part.tree}});
        }
    }
    return tests;
}

}  // namespace ecods
