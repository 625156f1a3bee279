// What the walks of a forest with the first boxes first share: its blocks and boxes as one kind of thing.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"
#include "ecods/aabb.hpp"

namespace ecods {

// A block of a tree, or a box. Orders by size, boxes last: what is equally near is opened before a box is visited, and
// boxes come in the order of their slots.
struct Part {
    std::uint32_t height = 0;  // 0: a box, otherwise the block's level and one
    std::uint32_t index = 0;   // of the block in its level, or the box's slot
    std::uint32_t tree = 0;

    bool is_box() const noexcept { return height == 0; }
    friend constexpr bool operator==(const Part&, const Part&) = default;
};

struct PartBox {
    Part part;
    Aabb box;
};

class Parts {
  public:
    Parts(std::span<const BoxTree> trees, std::span<const Aabb> boxes) : trees_(trees), boxes_(boxes) {}

    std::vector<Part> roots() const {
        std::vector<Part> roots;
        for (std::uint32_t tree = 0; tree < trees_.size(); ++tree) {
            if (trees_[tree].alive_count() > 0) roots.push_back({trees_[tree].level_count(), 0, tree});
        }
        return roots;
    }

    Aabb box_of(const Part& part) const {
        return part.is_box() ? boxes_[part.index]
                             : ecods::box_of(trees_[part.tree].block(part.height - 1, part.index).bounds());
    }

    // What lies in a block: up to eight.
    std::span<const PartBox> open(const Part& part, std::array<PartBox, BoxBlock::width>& lanes) const {
        const BoxTree& tree = trees_[part.tree];
        const BoxBlock& block = tree.block(part.height - 1, part.index);
        std::size_t count = 0;
        for (std::uint32_t lane = 0; lane < BoxBlock::width; ++lane) {
            const PackedBox line = block.get(lane);
            if (line.is_empty()) continue;
            const std::uint32_t child = part.index * BoxBlock::width + lane;
            if (part.height > 1) {
                lanes[count++] = {{part.height - 1, child, part.tree}, ecods::box_of(line)};
            } else {
                const SlotIndex slot = tree.slot(child);
                lanes[count++] = {{0, slot, part.tree}, boxes_[slot]};
            }
        }
        return std::span(lanes).first(count);
    }

  private:
    std::span<const BoxTree> trees_;
    std::span<const Aabb> boxes_;
};

// A part, by what it is at least: a distance, or a time.
struct NearPart {
    double lower;
    Part part;

    friend bool operator<(const NearPart& x, const NearPart& y) noexcept {
        if (x.lower != y.lower) return x.lower < y.lower;
        if (x.part.height != y.part.height) return x.part.height > y.part.height;
        return x.part.index < y.part.index;
    }
};

}  // namespace ecods
