// Cuts few triangles of a tree where the surface area heuristic says, looking at every way to cut them.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/tree/frame_box.hpp"

namespace ecods {

// A triangle's index and its box, which has a lane to spare for the index.
struct PrimitiveRef {
    FrameBox box;

    PrimitiveRef() = default;
    PrimitiveRef(const FrameBox& around, std::uint32_t triangle) : box(around) {
        box.min[3] = std::bit_cast<float>(triangle);
    }

    Float4 middle() const noexcept { return box.min + box.max; }  // twice
    std::uint32_t triangle() const noexcept {
        const float lane = box.min[3];
        return std::bit_cast<std::uint32_t>(lane);
    }
};
static_assert(sizeof(PrimitiveRef) == 32);

// The cost of visiting the leaves that this many triangles need, since a leaf is tested whole.
inline float leaf_visits(std::uint32_t count) noexcept {
    const std::size_t leaves = (count + tree_width - 1) / tree_width;
    return static_cast<float>(leaves);
}

// A block of items, in their orders along the three axes: sorted once for the block, and kept while it is cut into
// smaller and smaller parts.
class SweepSplit {
  public:
    static constexpr std::uint32_t size_max = 64;  // above it, sorting costs more than it gains

    // The items, at most size_max, as a block. They must outlive it.
    void begin(std::span<PrimitiveRef> items);

    // Cuts the part [begin, end) of the block, which is the whole block or one side of an earlier cut, and returns
    // where. The items of each side that is not more than a leaf are put into their order along the axis of the cut.
    std::uint32_t split(std::uint32_t begin, std::uint32_t end);

    // The box of the part, which is a side of the last cut.
    FrameBox box_of(std::uint32_t begin, std::uint32_t end) const noexcept;

  private:
    using Order = std::array<std::uint8_t, size_max>;  // places in copies_

    struct Cut {
        float cost = FrameBox::infinity;
        std::uint32_t size = 0;  // of the first side
        std::size_t axis = 0;
    };

    void sort(std::size_t axis);
    void sweep(std::uint32_t begin, std::uint32_t end, std::size_t axis, Cut& best) const noexcept;
    void part(Order& order, std::uint32_t begin, std::uint32_t end, std::uint64_t first_side) noexcept;
    void put_back(std::uint32_t begin, std::uint32_t end);

    std::span<PrimitiveRef> items_;
    std::array<PrimitiveRef, size_max> copies_;  // ascending by triangle
    std::array<Order, 3> orders_;
    std::size_t axis_ = 0;  // of the last cut
};

}  // namespace ecods
