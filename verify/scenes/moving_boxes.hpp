// Boxes that move, as a broad phase sees them: the same bits on every machine, and every bound is a float, so that
// engines of single precision are given the very boxes that the others are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ecods/primitives.hpp"

namespace ecods::scenes {

struct BoxMove {
    std::uint32_t index = 0;
    Aabb box;
    bool is_new = false;  // the box of this number goes, and another one comes in its place
};

struct MovingBoxes {
    std::string name;
    std::vector<Aabb> boxes;                   // at rest
    std::vector<std::vector<BoxMove>> frames;  // what moves; a box that is not named stays
};

enum class BoxLayout {
    dense,     // in a cube; about 5 partners a box
    sparse,    // in a cube; about 0.3
    pile,      // in one flat layer, a quarter of a box thick; about 5
    decades,   // in a cube; half extents from 1/2 to 500, evenly over their logarithm; about 5
    walls,     // dense, and one box of 500 is a plate half as wide as the cube, which stays
    clusters,  // in a cube; 500 boxes around each of some places, normally distributed; about 15
    ball,      // dense, in a ball
};

enum class BoxMotion {
    all,       // every box moves by `speed` times its size a frame, straight on until it turns at a wall
    tenth,     // a tenth of the boxes do, the same ones always
    teleport,  // all do, and 1 % of them jump anywhere instead
    none,
    hundredth,      // a hundredth of the boxes do, the same ones always
    random,         // a hundredth of the boxes do, others in each frame
    burst,          // none does in the first half of the frames, all do in the second
    churn,          // all do, and 5 % of them are new boxes anywhere instead
    churn_at_rest,  // 5 % are new boxes anywhere, the others stay
    one_new,        // one is a new box anywhere, the others stay
    turn,           // all turn about one axis together, by 0.9 degrees a frame; their extents stay
    fly,            // all fly five sizes a frame together
};

struct MovingBoxesOptions {
    BoxLayout layout = BoxLayout::dense;
    BoxMotion motion = BoxMotion::all;
    std::size_t count = 1000;
    std::size_t frame_count = 20;
    double speed = 0.01;
    std::uint32_t seed = 1;
};

MovingBoxes moving_boxes(const MovingBoxesOptions& options);

}  // namespace ecods::scenes
