// Elements as blocks; for building_relations.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include "scenes/building/building.hpp"

namespace ecods::scenes {

using Blocks = std::vector<Block>;

// What two blocks share: empty where min is above max.
inline Block common(const Block& a, const Block& b) noexcept {
    Block block;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        block.min[axis] = std::max(a.min[axis], b.min[axis]);
        block.max[axis] = std::min(a.max[axis], b.max[axis]);
    }
    return block;
}

inline bool is_empty(const Block& block) noexcept {
    return block.min[0] > block.max[0] || block.min[1] > block.max[1] || block.min[2] > block.max[2];
}

// The product of those extents that `like` has: a volume, or the area of a flat block.
inline Length measure(const Block& block, const Block& like) noexcept {
    if (is_empty(block)) return 0;
    Length product = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (like.min[axis] < like.max[axis]) product *= block.max[axis] - block.min[axis];
    }
    return product;
}

// The least block around an element.
Block bounds_of(const Element& element);

// The filled cells of a grid, which make up its solid.
Blocks solid_of(const Element& grid);

// The faces of a box that bounds no solid.
Blocks faces_of(const Element& box);

}  // namespace ecods::scenes
