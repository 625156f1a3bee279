// Sets of the tetrahedra into which the diagonals cut the cells of the integer lattice: solids with slanted faces of
// which every answer follows from the sets, as for cells.hpp.
#pragma once

#include <array>
#include <set>

#include "ecods/solid.hpp"
#include "scenes/cells.hpp"
#include "scenes/lattice_mesh.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

// A cell is cut into six, which share the diagonal from its least corner to its greatest: one for each order of axes,
// along which its corners follow each other.
using Tetrahedron = std::array<LatticePoint, 4>;
using Tetrahedra = std::set<Tetrahedron>;

// Some of those of a grid of that many cells in each direction, one at least.
Tetrahedra random_tetrahedra(int size, Random& random);

// The border: the faces of an odd number of them, each lattice point x taken to x * scale + by.
LatticeMesh boundary(const Tetrahedra& set, const LatticePoint& scale, const LatticePoint& by);

// How the solids that they fill are to each other; neither set is empty.
Relation relation(const Tetrahedra& a, const Tetrahedra& b);

}  // namespace ecods::scenes
