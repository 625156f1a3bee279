// What a query needs of a mesh, made once.
#pragma once

#include "bounds/triangle_tree.hpp"
#include "ecods/shape.hpp"
#include "exact/mesh_extent.hpp"

namespace ecods {

struct MeshShape::Tree {
    exact::MeshExtent extent;
    TriangleTree boxes;
};

}  // namespace ecods
