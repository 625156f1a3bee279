// Makes two two-body tests of meshes. Every world has the first test from the start.
#pragma once

#include <memory>

#include "ecods/shape.hpp"

namespace ecods {

// Both shapes given to the tests must be MeshShapes. The second test treats solids as their surfaces.
std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test();
std::shared_ptr<const TwoBodyTest> make_surface_surface_test();

}  // namespace ecods
