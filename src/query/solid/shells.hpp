// Finds the shells of a solid, and the outer side of each triangle. A shell is a set of triangles that are connected
// over edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

inline constexpr std::uint32_t no_shell = ~std::uint32_t{0};

struct Shells {
    std::vector<std::uint32_t> of_triangle;  // by triangle: its shell; no_shell if its area is zero
    std::vector<std::uint32_t> first;        // by shell: its least triangle
    std::vector<std::uint8_t> faces_in;      // by triangle: true if its corners turn right, seen from outside the solid
};

// Returns the shells of a mesh that bounds a solid. Any two of the mesh's sides must be the same edge or share at most
// a point. `tree` must be the mesh's tree. Cost: some passes over the triangles, and one ray for each shell.
Shells find_shells(const ProperMesh& proper, const MeshEdges& edges, const MeshTree& tree);

// Returns the only shell of a surface for which prove_star() has found `faces_in`. Cost: one pass over the triangles.
Shells shells_of_star(const ProperMesh& proper, std::span<const std::uint8_t> faces_in);

}  // namespace ecods
