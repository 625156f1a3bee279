// A MeshExtent is the data of a mesh that exact questions need under any pose: its box, bit ranges and common units.
#pragma once

#include <array>

#include "ecods/mesh.hpp"
#include "exact/number/common_unit.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// Describes the vertices that triangles use, by axis.
struct MeshExtent {
    Vec3 center;                      // of the vertices' box, rounded
    Vec3 half;                        // half the size of that box, rounded
    Vec3 magnitude;                   // the largest magnitude of a coordinate
    std::array<BitRange, 3> digits;   // the bits of all coordinates
    std::array<CommonUnit, 3> units;  // divide all coordinates
};

// Measures the vertices that triangles use. Cost: one pass over the triangles.
MeshExtent measure(const Mesh& mesh);

}  // namespace ecods::exact
