// Makes the two-body test of meshes, which every world has from the start.
#pragma once

#include <memory>

#include "ecods/two_body_test.hpp"

namespace ecods {

// Both shapes given to the test must be MeshShapes.
std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test();

}  // namespace ecods
