// What the exact layer wants to know of a mesh once, whatever its pose.
#pragma once

#include <array>

#include "ecods/mesh.hpp"
#include "exact/number/common_unit.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// Of the vertices that triangles use, on each axis.
struct MeshExtent {
    Vec3 center;     // of their box, rounded
    Vec3 half;       // of its size, rounded
    Vec3 magnitude;  // their largest coordinates in magnitude
    std::array<BitRange, 3> digits;
    std::array<CommonUnit, 3> units;  // of which they are multiples
};

// One pass over the triangles.
MeshExtent measure(const Mesh& mesh);

}  // namespace ecods::exact
