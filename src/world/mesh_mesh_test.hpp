// Makes the two-body test of meshes, which every world has from the start.
#pragma once

#include <memory>

#include "ecods/shape.hpp"
#include "ecods/two_body_test.hpp"

namespace ecods {

// Both shapes given to the tests must be MeshShapes. The second test takes solids for their surfaces.
std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test();
std::shared_ptr<const TwoBodyTest> make_surface_surface_test();

}  // namespace ecods
