// CGAL's answers about a point and a posed mesh, and about a mesh and itself.
#pragma once

#include <functional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/solid.hpp"

namespace ecods::bench {

// Makes Side_of_triangle_mesh, with its tree, of posed vertices, rounded. The mesh is an oriented manifold.
std::function<Side(const Vec3& point)> side_of_mesh_by_cgal(const Mesh& mesh, const Pose& pose);

// Makes a mesh ready for Polygon_mesh_processing: does_self_intersect(), which finds contacts at points, too.
std::function<bool()> self_intersection_by_cgal(const Mesh& mesh);

}  // namespace ecods::bench
