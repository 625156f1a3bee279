// What a mesh is as a shape.
#pragma once

#include <memory>
#include <string>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"

namespace ecods::clash {

struct MadeShape {
    std::shared_ptr<const MeshShape> shape;  // a ConvexSolid or a Solid if the mesh bounds one
    std::string not_solid_because;           // empty of a solid
};

// A convex mesh becomes a ConvexSolid if `may_be_convex`, otherwise a Solid.
MadeShape make_shape(const std::shared_ptr<const Mesh>& mesh, bool may_be_convex);

}  // namespace ecods::clash
