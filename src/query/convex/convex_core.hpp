// Recognizes shapes that are convex sets: a convex solid, or a mesh of one triangle (a point, a segment, a triangle).
#pragma once

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods::convex {

// Returns true if the shape is a convex solid, or a mesh of one triangle.
bool is_convex_core(const MeshShape& shape) noexcept;

// Returns a shape for which is_convex_core() is true as a convex solid. A mesh of one triangle becomes a flat solid,
// which is made on first use and kept with the shape: the shape must outlive the result. Many threads may call this
// function at once.
Posed<ConvexSolid> convex_core(const Posed<MeshShape>& posed);

}  // namespace ecods::convex
