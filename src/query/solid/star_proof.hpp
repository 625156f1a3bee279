// Proves that a surface is free of self-intersection if the whole surface is visible from one point.
#pragma once

#include <cstdint>
#include <vector>

#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// Tries to prove that every half-line from a point near the middle of the triangles' corners meets the surface once. If
// the proof succeeds, the surface is one shell with the point inside; no two triangles share a segment or more which is
// not a side of both; and no two different edges share a segment, so self_contacts.hpp would find nothing. The source
// file has the proof. The result then has an entry for each triangle, like Shells::faces_in: true if its corners turn
// right seen from outside.
//
// Returns an empty list if the proof fails. The surface may still be free of self-intersection, for example if it has a
// handle or several shells.
//
// Cost: one pass over the triangles and one over the edges, without the mesh's tree. Allocates one byte a triangle.
std::vector<std::uint8_t> prove_star(const ProperMesh& proper, const MeshEdges& edges);

}  // namespace ecods
