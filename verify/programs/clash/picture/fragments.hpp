// Which triangles are behind each sample of a picture, and how deep.
//
// A closed mesh is entered and left equally often along every line of sight: edges that two triangles share are rounded
// once, and rows and columns are half open. So what is inside what can be read off a sample's fragments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::clash {

// What a fragment belongs to.
enum class Layer : std::uint8_t {
    first,    // the clash's part a
    second,   // its part b
    context,  // other parts
    area,     // where the two lie on each other
    line,     // where their surfaces meet, and the closest points
};

// Triangles of one layer as a picture has them: x to the right and y down in samples, z away from the eye in the same
// unit.
struct ScreenMesh {
    std::vector<Vec3> points;
    std::span<const Triangle> triangles;
    Layer layer = Layer::first;
};

// What is in front of `cut_depth` of the context is cut away; of what is left only the nearest counts.
struct Screen {
    std::size_t width = 0;
    std::size_t height = 0;
    double cut_depth = 0;
};

struct Fragment {
    double depth = 0;
    std::uint32_t sample = 0;  // row * width + column in the band
    Layer layer = Layer::first;
    std::array<std::int8_t, 3> normal = {};  // of length 127, towards the eye
};

// Calls `draw` for bands of rows from top to bottom, each with its first row, its number of rows, and all their
// fragments by sample, then by depth, then by layer. Triangles beyond the picture's sides are left out.
struct Band {
    std::size_t first_row = 0;
    std::size_t row_count = 0;
    std::span<const Fragment> fragments;
};
void for_each_band(std::span<const ScreenMesh> meshes, const Screen& screen,
                   const std::function<void(const Band&)>& draw);

}  // namespace ecods::clash
