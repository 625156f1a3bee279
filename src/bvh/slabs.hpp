// What leaves and nodes know of the triangles in them, beyond boxes.
#pragma once

#include "bvh/mesh_bvh.hpp"

namespace ecods {

// Sets the corners of all leaves, for the triangles that are there already, and the slabs of leaves and nodes. Leaves
// must be in the order of the tree. Cost: one pass over the triangles a level.
void set_corners_and_slabs(MeshBvh& tree, const Mesh& mesh);

}  // namespace ecods
