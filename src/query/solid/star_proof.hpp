// A proof that a surface is free of self-intersection, for surfaces that are seen as a whole from one point.
#pragma once

#include <cstdint>
#include <vector>

#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

// If it is proven that, from a point in the middle of the triangles' corners, every half-line meets the surface once,
// the surface is one shell that has the point inside, and the result says by triangle whether its corners turn right
// seen from outside, as Shells::faces_in does. Otherwise the result is empty. If it is not, no two triangles share a
// segment or more which is not a side of both, and no two edges that are not one lie along each other: what
// self_contacts.hpp would search for is not there. Why is said in the source. A surface for which this is not proven,
// such as one with a handle or with several shells, may still be free of self-intersection.
//
// Cost: one pass over the triangles and one over the edges, without the mesh's tree. Nothing is allocated but a byte a
// triangle.
std::vector<std::uint8_t> prove_star(const ProperMesh& proper, const MeshEdges& edges);

}  // namespace ecods
