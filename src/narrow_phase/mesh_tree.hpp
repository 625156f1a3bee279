// What a query needs of a mesh, made once.
#pragma once

#include "bounds/wide_tree.hpp"
#include "ecods/shape.hpp"
#include "exact/mesh_extent.hpp"

namespace ecods {

struct MeshShape::Tree {
    exact::MeshExtent extent;
    WideTree boxes;
};

}  // namespace ecods
