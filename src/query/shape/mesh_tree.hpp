// What a query needs of a mesh, made once.
#pragma once

#include "bvh/mesh_bvh.hpp"
#include "ecods/shape.hpp"
#include "exact/point/mesh_extent.hpp"

namespace ecods {

struct MeshShape::Tree {
    exact::MeshExtent extent;
    MeshBvh boxes;
};

}  // namespace ecods
