// Proves that a surface is free of self-intersection if all of it is visible from one point.
#pragma once

#include <cstdint>
#include <vector>

#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// Tries to prove that every half-line from a point near the middle of the triangles' corners meets the surface once. If
// this is proven, the surface is one shell with the point inside; no two triangles share a segment or more which is not
// a side of both; and no two different edges share a segment, so self_contacts.hpp would find nothing. The source file
// has the proof. The result then says, by triangle, whether its corners turn right seen from outside, like
// Shells::faces_in.
//
// Returns an empty list if this is not proven. Even then a surface, for example one with a handle or with several
// shells, may be free of self-intersection.
//
// Cost: one pass over the triangles and one over the edges, without the mesh's tree. Allocates one byte a triangle.
std::vector<std::uint8_t> prove_star(const ProperMesh& proper, const MeshEdges& edges);

}  // namespace ecods
