// As what a world is given a mesh: a surface, a solid, or a convex solid.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"
#include "trace/mesh_form.hpp"

namespace ecods::fuzz {

// Returns the form of a mesh's shape, or of a rounded shape's core; `surface` for any other shape.
MeshForm form_of(const Shape& shape) noexcept;

// Returns 0 for a shape that is not rounded.
double radius_of(const Shape& shape) noexcept;

// Returns 0 to 2 of a polygon, a segment or a point as a convex solid, or as the core of a rounded shape; of others 3.
int dimension_of(const Shape& shape) noexcept;

// Whether make_shape() would not throw. Cost: that of making it.
bool has_form(const std::shared_ptr<const Mesh>& mesh, MeshForm form);

}  // namespace ecods::fuzz
