// Boxes for the tests of the structures that find them, and what brute force finds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/packed_box.hpp"
#include "scenes/random.hpp"

namespace ecods::test {

enum class Spread { cube, line, one_place, decades };
constexpr Spread all_spreads[] = {Spread::cube, Spread::line, Spread::one_place, Spread::decades};

// About a handful of partners each, but for those in one place, which all overlap. Lattice points, so that many touch.
inline std::vector<Aabb> random_boxes(std::size_t count, Spread spread, std::uint32_t seed = 1) {
    scenes::Random random(seed);
    const auto below = [&](double limit) { return std::floor(random.uniform(0, limit)); };
    const double side = spread == Spread::line ? static_cast<double>(count) : 4 * std::cbrt(static_cast<double>(count));
    std::vector<Aabb> boxes(count);
    for (Aabb& box : boxes) {
        const double size = spread == Spread::decades ? std::pow(10.0, random.uniform(-2, 1)) : below(4);
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_spread = spread != Spread::one_place && (spread != Spread::line || axis == 1);
            box.min[axis] = is_spread ? below(side) - side / 2 : 0;
            box.max[axis] = box.min[axis] + size;
        }
    }
    return boxes;
}

inline std::vector<PackedBox> lines_of(const std::vector<Aabb>& boxes) {
    std::vector<PackedBox> lines(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) make_packed_box(boxes[i], lines[i]);
    return lines;
}

using SlotPair = std::array<SlotIndex, 2>;

inline std::vector<SlotIndex> sorted(std::vector<SlotIndex> slots) {
    std::sort(slots.begin(), slots.end());
    return slots;
}

// Each with the smaller slot first, ascending; one that is there twice stays so.
inline std::vector<SlotPair> sorted(std::vector<SlotPair> pairs) {
    for (SlotPair& pair : pairs) std::sort(pair.begin(), pair.end());
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

// By the numbers, not the lanes.
inline std::vector<SlotIndex> overlapping_slots(const PackedBox& line, const std::vector<PackedBox>& lines) {
    std::vector<SlotIndex> found;
    for (SlotIndex slot = 0; slot < lines.size(); ++slot) {
        if (!lines[slot].is_empty() && overlap(line, lines[slot])) found.push_back(slot);
    }
    return found;
}
inline std::vector<SlotPair> overlapping_slot_pairs(const std::vector<PackedBox>& lines) {
    std::vector<SlotPair> found;
    for (SlotIndex a = 0; a < lines.size(); ++a) {
        for (SlotIndex b = a + 1; b < lines.size(); ++b) {
            if (!lines[a].is_empty() && !lines[b].is_empty() && overlap(lines[a], lines[b])) found.push_back({a, b});
        }
    }
    return found;
}

}  // namespace ecods::test
