// A CurvedBody is the set that a polytope must contain. Exact integers decide whether the polytope contains the body,
// and bound the distance of the polytope's points from the body.
#pragma once

#include <array>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::builders {

// A CurvedPart is an ellipsoid, a disc or a point: all points p with (p.x / radii[0])^2 + (p.y / radii[1])^2 + ((p.z -
// z) / radii[2])^2 <= 1. If a radius is zero, its numerator must be zero.
struct CurvedPart {
    std::array<double, 3> radii;
    double z;
};

// A CurvedBody is the convex hull of its parts: two discs make a cylinder, a point and a disc a cone. The radii of the
// last part that are not zero are the body's.
using CurvedBody = std::vector<CurvedPart>;

// Returns true if the body is on the inner side of the plane of each triangle of the mesh, which must face outwards.
//
// A plane n.x = d has a part on its inner side if and only if n_z z + h <= d, where h^2 = sum (radii[i] n_i)^2 is the
// square of the part's extent along n: so d - n_z z must not be negative, and its square must be at least h^2.
// Claim: verify/proofs/outer_polytopes.md
bool contains(const Mesh& polytope, const CurvedBody& body);

// Returns an upper bound of the distance of the mesh's points from the body, rounded up: (rho - 1) m. Here rho is the
// largest factor by which a vertex is outside, rho^2 = max sum (p_i / radii[i])^2 over the radii of the last part that
// are not zero, and m is the largest of these radii. The mesh must contain the body. If the last part is a disc, all
// vertices must be in the planes of parts.
//
// Derivation. The distance from a convex set is largest at a vertex of a polytope. For a vertex p around an ellipsoid
// E, p / rho is in E, and its distance from p is (rho - 1) |p / rho| <= (rho - 1) m. A vertex in the plane of a disc is
// |p| - m = (|p| / m - 1) m from the disc's rim, and no point of a cylinder or cone is nearer.
// Claim: verify/proofs/outer_polytopes.md
double deviation(const Mesh& polytope, const CurvedBody& body);

}  // namespace ecods::builders
