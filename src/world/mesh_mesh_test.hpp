// The two-body test of meshes, as every world has it from the start.
#pragma once

#include <memory>

#include "ecods/shape.hpp"

namespace ecods {

// Both shapes must be MeshShapes.
std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test();

}  // namespace ecods
