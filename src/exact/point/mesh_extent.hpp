// A MeshExtent has the data of a mesh that exact arithmetic needs under any pose: the box, the bit ranges and the
// common units of the coordinates.
#pragma once

#include <array>

#include "ecods/mesh.hpp"
#include "exact/number/common_unit.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// A MeshExtent describes the coordinates of the vertices that triangles use, by axis.
struct MeshExtent {
    Vec3 center;                      // center of the vertices' box, rounded
    Vec3 half;                        // half the size of that box, rounded
    Vec3 magnitude;                   // largest |coordinate|
    std::array<BitRange, 3> digits;   // range of the binary digits of all coordinates
    std::array<CommonUnit, 3> units;  // greatest unit of which all coordinates are multiples
};

// Computes the extent of a mesh. Cost: one pass over the triangles.
MeshExtent measure(const Mesh& mesh);

}  // namespace ecods::exact
