// What the exact layer wants to know of a mesh once, whatever its pose.
#pragma once

#include <array>

#include "ecods/mesh.hpp"
#include "exact/dyadic.hpp"

namespace ecods::exact {

// Of the vertices that triangles use, on each axis.
struct MeshExtent {
    Vec3 min;
    Vec3 max;
    std::array<BitRange, 3> digits;

    Vec3 magnitude() const { return min.cwiseAbs().cwiseMax(max.cwiseAbs()); }
};

// One pass over the triangles.
MeshExtent measure(const Mesh& mesh);

}  // namespace ecods::exact
