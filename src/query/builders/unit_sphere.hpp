// Makes meshes with vertices on the unit sphere.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::builders {

struct UnitSphere {
    std::vector<std::array<std::int64_t, 3>> points;  // in fixed point, within a few units
    std::vector<Triangle> triangles;                  // facing outwards
};

// Returns an icosahedron whose triangles are divided into four at the middles of their sides, `subdivisions` times. The
// middles are moved out to the sphere. From the first subdivision on, there is a vertex on each half axis.
UnitSphere subdivide_icosahedron(std::uint32_t subdivisions);

}  // namespace ecods::builders
