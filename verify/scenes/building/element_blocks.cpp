#include "scenes/building/element_blocks.hpp"

namespace ecods::scenes {
namespace {

Block block_of(const Element& element, Length u_min, Length u_max, Length v_min, Length v_max) {
    const auto w = static_cast<std::size_t>(element.axis);
    Block block;
    block.min[(w + 1) % 3] = u_min;
    block.max[(w + 1) % 3] = u_max;
    block.min[(w + 2) % 3] = v_min;
    block.max[(w + 2) % 3] = v_max;
    block.min[w] = element.lo;
    block.max[w] = element.hi;
    return block;
}

}  // namespace

Block bounds_of(const Element& element) {
    const Length r = element.radius;
    if (element.is_pipe()) return block_of(element, element.u - r, element.u + r, element.v - r, element.v + r);
    return block_of(element, element.us.front(), element.us.back(), element.vs.front(), element.vs.back());
}

Blocks solid_of(const Element& grid) {
    Blocks blocks;
    const std::size_t width = grid.us.size() - 1;
    for (std::size_t cell = 0; cell < grid.filled.size(); ++cell) {
        if (grid.filled[cell] == 0) continue;
        const std::size_t i = cell % width;
        const std::size_t j = cell / width;
        blocks.push_back(block_of(grid, grid.us[i], grid.us[i + 1], grid.vs[j], grid.vs[j + 1]));
    }
    return blocks;
}

Blocks faces_of(const Element& box) {
    Blocks faces;
    const Block bounds = bounds_of(box);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Block low = bounds;
        Block high = bounds;
        low.max[axis] = low.min[axis];
        high.min[axis] = high.max[axis];
        faces.push_back(low);
        const bool is_left_out = box.defect == Defect::open && axis == static_cast<std::size_t>(box.axis);
        if (!is_left_out) faces.push_back(high);
    }
    return faces;
}

}  // namespace ecods::scenes
