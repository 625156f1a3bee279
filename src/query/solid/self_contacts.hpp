// How the triangles of a proper mesh meet each other, in the mesh's own coordinates. `tree` is that of the mesh that
// `proper` was made of.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ids.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// Two different edges that lie along each other, as sides of two triangles.
struct EdgeOverlap {
    SideRef a;
    SideRef b;
};

// The least pair of triangles that share a segment or more which is not a side of both, if there is one. If there is
// none, `overlaps` are the sides that lie along each other and are not one edge.
std::optional<TrianglePair> least_self_contact(const ProperMesh& proper, const MeshTree& tree,
                                               std::vector<EdgeOverlap>& overlaps);

// All such pairs, ascending.
std::vector<TrianglePair> all_self_contacts(const ProperMesh& proper, const MeshTree& tree);

}  // namespace ecods
