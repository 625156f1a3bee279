// The space ship of the ECoDS report's experiments, made anew: 430 triangles and 300 vertices.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

// The nose points along x, the wings along y, the fins along z. It is 2 long and 2 wide, and its vertices are multiples
// of 2^-20, the same on every machine. As models of games are, it is put together from pieces that pass through each
// other (wings stick in the hull), some of them open, and its hull is plated: plates have vertices of their own.
std::shared_ptr<const Mesh> ship();

// The largest distance of a vertex of the ship from its origin, rounded up a little.
double ship_radius();

}  // namespace ecods::scenes
