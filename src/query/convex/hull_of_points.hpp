// Finds the convex hull of points, as triangles.
#pragma once

#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::convex {

// The triangles of the hull's border, turned outwards; each edge has two triangles. Corners are indices of points, of
// equal points the first. A corner may lie inside a face or an edge of the hull. Throws NoInterior.
std::vector<Triangle> triangulate_hull(std::span<const Vec3> points);

}  // namespace ecods::convex
