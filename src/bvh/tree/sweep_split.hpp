// SweepSplit splits small sets of triangles by the surface area heuristic; it tries every cut along the three axes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/tree/frame_box.hpp"

namespace ecods {

// Holds a triangle's box and index. The index is stored in the unused fourth lane of box.min.
struct PrimitiveRef {
    FrameBox box;

    PrimitiveRef() = default;
    PrimitiveRef(const FrameBox& around, std::uint32_t triangle) : box(around) {
        box.min[3] = std::bit_cast<float>(triangle);
    }

    Float4 middle() const noexcept { return box.min + box.max; }  // twice the middle of the box
    std::uint32_t triangle() const noexcept {
        const float lane = box.min[3];
        return std::bit_cast<std::uint32_t>(lane);
    }
};
static_assert(sizeof(PrimitiveRef) == 32);

// Returns the number of leaves for `count` triangles. This number is the cost of visiting the triangles, since a leaf
// is tested as a whole.
inline float leaf_visits(std::uint32_t count) noexcept {
    const std::size_t leaves = (count + tree_width - 1) / tree_width;
    return static_cast<float>(leaves);
}

// Holds a block of items and their orders along the three axes. Each order is sorted once for the block, and stays
// sorted while the block is split into smaller and smaller parts.
class SweepSplit {
  public:
    static constexpr std::uint32_t size_max = 64;  // for larger blocks, sorting costs more than it saves

    // Starts a block of at most size_max items. `items` must remain valid while the block is split.
    void begin(std::span<PrimitiveRef> items);

    // Splits the part [begin, end) of the block, which must be the whole block or one side of an earlier split. Returns
    // the beginning of the second side. If a side fits into a leaf, its items are put into their order along the axis
    // of the cut.
    std::uint32_t split(std::uint32_t begin, std::uint32_t end);

    // Returns the box of the part [begin, end), which must be one side of the last split.
    FrameBox box_of(std::uint32_t begin, std::uint32_t end) const noexcept;

  private:
    using Order = std::array<std::uint8_t, size_max>;  // indices into copies_

    struct Cut {
        float cost = FrameBox::infinity;
        std::uint32_t size = 0;  // number of items in the first side
        std::size_t axis = 0;
    };

    void sort(std::size_t axis);
    void sweep(std::uint32_t begin, std::uint32_t end, std::size_t axis, Cut& best) const noexcept;
    void part(Order& order, std::uint32_t begin, std::uint32_t end, std::uint64_t first_side) noexcept;
    void put_back(std::uint32_t begin, std::uint32_t end);

    std::span<PrimitiveRef> items_;
    std::array<PrimitiveRef, size_max> copies_;  // the items, sorted by triangle
    std::array<Order, 3> orders_;
    std::size_t axis_ = 0;  // axis of the last cut
};

}  // namespace ecods
