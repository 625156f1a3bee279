// Sets of unit cells of the integer lattice: solids of which every answer follows from comparing integers.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ecods/solid.hpp"

namespace ecods::scenes {

using LatticePoint = std::array<int, 3>;

// The cubes [x, x + 1] x [y, y + 1] x [z, z + 1] for the points (x, y, z): ascending, each once.
using Cells = std::vector<LatticePoint>;

Cells sorted(Cells cells);
Cells shifted(const Cells& cells, const LatticePoint& by);
bool contains(const Cells& cells, const LatticePoint& cell);

// How the solids that they fill are to each other; neither set is empty. Cells touch if no coordinates of theirs
// differ by more than one.
Relation relation(const Cells& a, const Cells& b);

// Where half of this point is: inside if all cells that hold it are in the set, outside if none is.
Side side_of(const LatticePoint& doubled, const Cells& cells);

// All connected sets of up to `size_max` cells, one for each translation, their least coordinates 0: of one cell one,
// of up to two 4, of up to three 19, of up to four 105.
std::vector<Cells> polycubes(std::size_t size_max);

}  // namespace ecods::scenes
