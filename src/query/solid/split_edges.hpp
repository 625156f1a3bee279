// The triangles of a solid, edges divided where others that lie along them end.
#pragma once

#include <span>

#include "query/solid/self_contacts.hpp"

namespace ecods {

// Divides triangles without a new vertex, until edges are either one edge or share at most a point. `overlaps` has each
// two edges of the mesh that lie along each other. Zero-area triangles are left out. Cost: n log n in the overlaps, and
// a pass over the triangles.
ProperMesh split_edges(const ProperMesh& proper, std::span<const EdgeOverlap> overlaps);

}  // namespace ecods
