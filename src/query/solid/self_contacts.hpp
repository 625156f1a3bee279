// Finds the pairs of triangles of a proper mesh that meet in more than common sides or corners, in the mesh's
// coordinates. `tree` must be the tree of the mesh from which `proper` was made.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ids.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// An EdgeOverlap is two different edges that overlap along a segment, each as a side of a triangle.
struct EdgeOverlap {
    SideRef a;
    SideRef b;
};

// Returns the least pair of triangles that share a segment or more which is not a side of both; nullopt if there is no
// such pair. In the latter case, appends to `overlaps` the pairs of sides that overlap along a segment but are
// different edges.
std::optional<TrianglePair> least_self_contact(const ProperMesh& proper, const MeshTree& tree,
                                               std::vector<EdgeOverlap>& overlaps);

// Returns all pairs of triangles that share a segment or more which is not a side of both, ascending.
std::vector<TrianglePair> all_self_contacts(const ProperMesh& proper, const MeshTree& tree);

}  // namespace ecods
