// Convex polytopes whose corners are integers: their hulls are found by trying every plane through three points, in
// integers, and without the library.
#pragma once

#include <span>
#include <vector>

#include "scenes/lattice_mesh.hpp"

namespace ecods::scenes {

// The hull's faces, turned outwards, each a fan from one of its corners; points that are no corners are left out. No
// triangles if all points lie in one plane. Coordinates are below 2^17. Cost: n^3 for n points, of which most end
// early: a millisecond for 30.
LatticeMesh lattice_hull(std::span<const LatticePoint> points);

// The same surface, larger by two: each triangle in four, so that there are vertices inside edges and faces.
LatticeMesh refined(const LatticeMesh& mesh);

// The hull of some points of [-size, size]^3, which has an inside.
LatticeMesh random_lattice_hull(int size, int point_count, Random& random);

// The hull of points on an ellipsoid, whose radii are at most one, in units of 2^-16.
LatticeMesh ellipsoid_hull(int point_count, const Vec3& radii, Random& random);
inline constexpr double ellipsoid_unit = 0x1p-16;

// Two hulls of points of a circle, `height` apart; each coordinate at most `radius`.
LatticeMesh prism(int side_count, int radius, int height);

// As it is, but for a factor.
std::shared_ptr<const Mesh> to_mesh(const LatticeMesh& mesh, double unit);

}  // namespace ecods::scenes
