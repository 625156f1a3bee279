// triangulate_hull() computes the convex hull of points, as triangles.
#pragma once

#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::convex {

// Returns the triangles that make up the border of the hull, facing outwards; each edge is shared by two of them.
// Corners are indices of points; of equal points the first is used. A corner may lie inside a face or an edge of the
// hull. The result is empty if all points are in one plane.
std::vector<Triangle> triangulate_hull(std::span<const Vec3> points);

}  // namespace ecods::convex
