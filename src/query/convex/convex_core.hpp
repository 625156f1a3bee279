// Convex sets that are given as a mesh: a convex solid, or a mesh of one triangle (a point, a segment, a triangle).
#pragma once

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods::convex {

// True if the shape is a convex solid, or a mesh of one triangle.
bool is_convex_core(const MeshShape& shape) noexcept;

// Returns such a shape as a convex solid. A mesh of one triangle is made a flat one, which the result keeps.
Posed<ConvexSolid> convex_core(const Posed<MeshShape>& posed);

}  // namespace ecods::convex
