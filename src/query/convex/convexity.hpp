// require_convex() decides whether a solid is convex, and throws NotSolid if it is not.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "query/convex/hull_build.hpp"
#include "query/solid/shells.hpp"

namespace ecods::convex {

// Returns, by edge of the border, whether the edge is flat. Throws NotSolid, with the indices of `given`, unless the
// solid is convex.
//
// A closed surface that is convex along each of its edges, connected over edges and free of self-intersection bounds a
// convex set. Proof: around a vertex its triangles make a simple spherical polygon without dents, so the surface is
// convex there, too. A surface that is convex everywhere and bends somewhere bounds a convex set as a whole (van
// Heijenoort, On locally convex manifolds, 1952).
//
// Cost: an orient3d for each edge.
std::vector<std::uint8_t> require_convex(const Border& border, const Shells& shells, const Mesh& given);

}  // namespace ecods::convex
