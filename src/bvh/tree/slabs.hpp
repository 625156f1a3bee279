// Computes leaf corners, and a slab (one-normal k-DOP) for each node and leaf.
#pragma once

#include "bvh/tree/mesh_bvh.hpp"

namespace ecods {

// Sets the corners and vertices of all leaves and the slabs of all leaves and nodes, from the triangles that the leaves
// name. Leaves must be in the order of the tree. Cost: one pass over the triangles per level.
void set_corners_and_slabs(MeshBvh& tree, const Mesh& mesh);

}  // namespace ecods
