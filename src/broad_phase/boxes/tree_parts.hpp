// Treats the blocks and boxes of a forest as one kind of item, a part, with an order for priority queues. All
// best-first walks share this.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "bvh/walks/waiting.hpp"
#include "ecods/primitives.hpp"
#include "simd/inline.hpp"

namespace ecods {

// Names a block of a tree, or a box.
struct Part {
    std::uint32_t height = 0;  // 0 for a box, otherwise the block's level plus one
    std::uint32_t index = 0;   // index of the block in its level, or the box's slot
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

    // Returns the blocks or boxes in a block, at most eight, in the memory of `lanes`.
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

// Holds a block or a box with a lower bound of a distance or a time, which is not negative. Parts are ordered by their
// bounds. If bounds are equal, blocks come before boxes, so that all blocks are opened before a box is visited, and
// boxes come in the order of their slots. A part of height `position` is a box whose slot is not looked up yet.
class BoundedPart {
  public:
    static constexpr std::uint32_t box = 0, position = 1,
                                   block = 2;  // values of height(); for blocks, `block` plus the level

    BoundedPart() = default;
    // `index` is the index of the block in its level, the position, or the box's slot.
    BoundedPart(double lower, std::uint32_t height, std::uint32_t index, std::uint32_t tree) noexcept
        : lower_(std::bit_cast<std::uint64_t>(lower)),
          place_(std::uint64_t{height_max - height} << 56 | std::uint64_t{index} << 24 | tree) {
        ECODS_ASSERT(height <= height_max && tree < 1u << 24 && std::bit_cast<std::int64_t>(lower) >= 0);
    }

    double lower() const noexcept { return std::bit_cast<double>(lower_); }
    std::uint32_t height() const noexcept { return height_max - static_cast<std::uint32_t>(place_ >> 56); }
    std::uint32_t index() const noexcept { return static_cast<std::uint32_t>(place_ >> 24); }
    std::uint32_t tree() const noexcept { return static_cast<std::uint32_t>(place_) & 0xffffff; }

    // Compares two parts without branches, as the outcome is unpredictable.
    ECODS_ALWAYS_INLINE friend bool operator<(const BoundedPart& a, const BoundedPart& b) noexcept {
        return ((a.lower_ < b.lower_) | ((a.lower_ == b.lower_) & (a.place_ < b.place_))) != 0;
    }

  private:
    static constexpr std::uint32_t height_max = 255;

    std::uint64_t lower_ = 0;  // bits of the bound: bits of nonnegative doubles are ordered as the doubles are
    std::uint64_t place_ = 0;  // from the most significant bit on: height_max - height, the index, the tree
};

}  // namespace ecods
