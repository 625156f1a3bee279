// set_corners_and_slabs computes the corners in leaves, and a slab (a k-DOP with one normal) for each node and leaf.
#pragma once

#include "bvh/tree/mesh_bvh.hpp"

namespace ecods {

// Sets the corners and vertices of all leaves, and the slabs of all leaves and nodes, from the indices of triangles in
// the leaves. Leaves must be in the order of the tree. Cost: one pass over the triangles for each level of the tree.
void set_corners_and_slabs(MeshBvh& tree, const Mesh& mesh);

}  // namespace ecods
