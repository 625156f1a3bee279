// Small meshes with hard geometry.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"
#include "fuzz/counters.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// A lattice tetrahedron, a cube, a soup of lattice triangles, zero-area triangles, a sliver, a tetrahedron of
// arbitrary doubles or of decimals, at most 12 triangles, of about the size `unit`.
std::shared_ptr<const Mesh> make_mesh(double unit, scenes::Random& random, Counters& counters);

}  // namespace ecods::fuzz
