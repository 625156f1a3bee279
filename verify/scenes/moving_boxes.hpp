// Boxes that move, as a broad phase sees them: the same bits on every machine, and every bound is a float, so that
// engines of single precision are given the very boxes that the others are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ecods/aabb.hpp"

namespace ecods::scenes {

struct BoxMove {
    std::uint32_t index = 0;
    Aabb box;
};

struct MovingBoxes {
    std::string name;
    std::vector<Aabb> boxes;                   // at rest
    std::vector<std::vector<BoxMove>> frames;  // what moves; a box that is not named stays
};

enum class BoxLayout {
    dense,    // in a cube; about 5 partners a box
    sparse,   // in a cube; about 0.3
    pile,     // in one flat layer, a quarter of a box thick; about 5
    decades,  // in a cube; half extents from 1/2 to 500, evenly over their logarithm; about 5
};

enum class BoxMotion {
    all,       // every box moves 1 % of its size a frame, straight on until it turns at a wall
    tenth,     // a tenth of the boxes do, the same ones always
    teleport,  // all do, and 1 % of them jump anywhere instead
    none,
};

struct MovingBoxesOptions {
    BoxLayout layout = BoxLayout::dense;
    BoxMotion motion = BoxMotion::all;
    std::size_t count = 1000;
    std::size_t frame_count = 20;
    std::uint32_t seed = 1;
};

MovingBoxes moving_boxes(const MovingBoxesOptions& options);

}  // namespace ecods::scenes
