// The pose-independent data of a mesh for exact questions: its box, bit ranges and common units.
#pragma once

#include <array>

#include "ecods/mesh.hpp"
#include "exact/number/common_unit.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// The extent of the vertices that triangles use, by axis.
struct MeshExtent {
    Vec3 center;                      // of the vertices' box, rounded
    Vec3 half;                        // half the size of that box, rounded
    Vec3 magnitude;                   // the largest magnitude of a coordinate
    std::array<BitRange, 3> digits;   // the bits of all coordinates
    std::array<CommonUnit, 3> units;  // of which all coordinates are multiples
};

// Cost: one pass over the triangles.
MeshExtent measure(const Mesh& mesh);

}  // namespace ecods::exact
