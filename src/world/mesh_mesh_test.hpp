// Makes the two-body test of meshes, which every world has from the start.
#pragma once

#include <memory>

#include "ecods/shape.hpp"

namespace ecods {

// Returns a test that requires both shapes to be MeshShapes.
std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test();

}  // namespace ecods
