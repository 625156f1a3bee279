// Finds how the triangles of a proper mesh meet each other, in the mesh's own coordinates. `tree` is the tree of the
// mesh that `proper` was made from.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ids.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// Two different edges that overlap along a segment, each given as a side of a triangle.
struct EdgeOverlap {
    SideRef a;
    SideRef b;
};

// The least pair of triangles that share a segment or more which is not a side of both; nullopt if there is none. In
// that case `overlaps` receives the pairs of sides that overlap along a segment without being one edge.
std::optional<TrianglePair> least_self_contact(const ProperMesh& proper, const MeshTree& tree,
                                               std::vector<EdgeOverlap>& overlaps);

// All such pairs of triangles, ascending.
std::vector<TrianglePair> all_self_contacts(const ProperMesh& proper, const MeshTree& tree);

}  // namespace ecods
