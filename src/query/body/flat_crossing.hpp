// Decides whether flat convex sets cross: they are in no common plane and share a point of the relative interior of
// both.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns true if the shape is a polygon, a segment or a point, at a regular pose.
bool is_flat_set(const Posed<MeshShape>& body);

// Returns true if a flat set and the other body cross. The other body is a flat set or a surface; a surface is crossed
// if one of its triangles is. The bodies must share a point, and no two of their triangles may cross. Cost: that of
// intersecting_triangles() for a surface, and some exact signs for each corner of a polygon and for each triangle that
// it meets.
bool do_flat_cross(const Posed<MeshShape>& flat, const Posed<MeshShape>& other, QueryMemory& memory);

}  // namespace ecods
