// Small meshes with hard geometry.
#pragma once

#include <memory>
#include <string>

#include "ecods/mesh.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/motion/profile.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Of about the size `unit`. Hard: a lattice tetrahedron, a cube, a soup of lattice triangles, zero-area triangles, a
// sliver, a tetrahedron of arbitrary doubles or of decimals; at most 12 triangles. Cubes: with edges of one unit, or of
// one by two. Round: spheres and tori of 48 to 256 triangles. Solids: cubes, bricks, octahedra, spheres, polycubes, and
// a cube with a cavity; each bounds a solid before it is scaled, which is asked of the oracle. Among them are squares,
// segments and points, which are flat convex solids.
std::shared_ptr<const Mesh> make_mesh(Meshes menu, double unit, scenes::Random& random, Counters& counters);

// Throws CheckFailed, as of a wrong recipe, where the mesh bounds no solid by the oracle.
void require_solid(const std::string& name, const Mesh& mesh);

// The same triangles, with vertices that have moved: by a little, by their own size, or all into one plane.
std::shared_ptr<const Mesh> deformed(const Mesh& mesh, double unit, scenes::Random& random);

}  // namespace ecods::fuzz
