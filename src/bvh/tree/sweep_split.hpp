// Splits small sets of triangles by the surface area heuristic, trying every cut along the three axes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/tree/frame_box.hpp"

namespace ecods {

// A triangle's index and its box; the box has a spare lane, which holds the index.
struct PrimitiveRef {
    FrameBox box;

    PrimitiveRef() = default;
    PrimitiveRef(const FrameBox& around, std::uint32_t triangle) : box(around) {
        box.min[3] = std::bit_cast<float>(triangle);
    }

    Float4 middle() const noexcept { return box.min + box.max; }  // twice the middle
    std::uint32_t triangle() const noexcept {
        const float lane = box.min[3];
        return std::bit_cast<std::uint32_t>(lane);
    }
};
static_assert(sizeof(PrimitiveRef) == 32);

// Returns the number of leaves that this many triangles need: the cost of visiting them, since a leaf is tested whole.
inline float leaf_visits(std::uint32_t count) noexcept {
    const std::size_t leaves = (count + tree_width - 1) / tree_width;
    return static_cast<float>(leaves);
}

// A block of items with their orders along the three axes. The orders are sorted once for the block, and stay sorted
// while it is cut into smaller and smaller parts.
class SweepSplit {
  public:
    static constexpr std::uint32_t size_max = 64;  // for larger blocks, sorting costs more than it gains

    // Starts a block of `items`, at most size_max, which must outlive the block.
    void begin(std::span<PrimitiveRef> items);

    // Splits the part [begin, end) of the block, which is the whole block or one side of an earlier split, and returns
    // where the second side begins. The items of each side that fits into a leaf are put into their order along the
    // axis of the cut.
    std::uint32_t split(std::uint32_t begin, std::uint32_t end);

    // Returns the box of the part, which must be a side of the last split.
    FrameBox box_of(std::uint32_t begin, std::uint32_t end) const noexcept;

  private:
    using Order = std::array<std::uint8_t, size_max>;  // places in copies_

    struct Cut {
        float cost = FrameBox::infinity;
        std::uint32_t size = 0;  // size of the first side
        std::size_t axis = 0;
    };

    void sort(std::size_t axis);
    void sweep(std::uint32_t begin, std::uint32_t end, std::size_t axis, Cut& best) const noexcept;
    void part(Order& order, std::uint32_t begin, std::uint32_t end, std::uint64_t first_side) noexcept;
    void put_back(std::uint32_t begin, std::uint32_t end);

    std::span<PrimitiveRef> items_;
    std::array<PrimitiveRef, size_max> copies_;  // ascending by triangle
    std::array<Order, 3> orders_;
    std::size_t axis_ = 0;  // axis of the last cut
};

}  // namespace ecods
