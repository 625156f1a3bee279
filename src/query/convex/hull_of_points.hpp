// Finds the convex hull of points, as triangles.
#pragma once

#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::convex {

// Triangles that make up the border of the hull, turned outwards, their edges shared by two each. Corners are indices
// of points, of equal ones the first; a corner may lie inside a face or an edge of the hull. Throws NotSolid.
std::vector<Triangle> triangulate_hull(std::span<const Vec3> points);

}  // namespace ecods::convex
