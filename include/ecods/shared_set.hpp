// What two triangles share, and features that are near each other (contact.hpp says how to ask).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "ecods/closest_points.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

// What two triangles share: a point (one corner), a segment (two), or a convex polygon of a common plane.
struct SharedSet {
    std::size_t corner_count = 0;  // 1 to 6; 0 if they share nothing

    // The lexicographically least of the real points comes first. A polygon's others follow counterclockwise as seen
    // from where `normal` points to, which is the first triangle's. Each coordinate is rounded once; a zero is +0.
    std::array<Vec3, 6> all_corners{};

    // A unit vector, each coordinate the true one rounded once, a zero +0, where one face or two edges define it. If
    // what is shared lies inside the face of one triangle and in a vertex or an edge of the other, it is the normal of
    // that face, (q - p) x (r - p) of its corners p, q and r; if it lies in both faces, that of the first triangle's.
    // If it is one point inside an edge of each, not parallel, it is the product of the first triangle's edge and the
    // second's, each from its corner to the next one; of edges of a zero-area triangle that lie on each other, that of
    // the least corner counts. Nothing where a vertex meets a vertex or an edge, edges lie along each other, or the
    // triangles cross.
    std::optional<Vec3> normal;

    std::span<const Vec3> corners() const noexcept { return std::span(all_corners).first(corner_count); }
};

struct TriangleIntersection {
    TrianglePair triangles;
    SharedSet shared;
};

// Two features that are near each other.
//
// Vertices, edges and faces are those of the meshes, whatever triangles they are named by: corners at equal coordinates
// are one vertex (-0 is 0), edges between the same two vertices are one edge, and a face is that of its own triangle.
// Each is named by the least triangle and corner of the whole mesh that name it.
struct CloseFeatures {
    // The two features with their own distance and closest points. Features that touch have distance 0.
    ClosestPoints closest;

    // A unit vector, each coordinate the true one rounded once; a zero is +0. At a positive distance it is that from
    // the closest point of `a` to that of `b`. At distance 0 it is the normal, (q - p) x (r - p) of the corners p, q
    // and r of the face, where a vertex touches one; the product of the edge of `a` and that of `b`, each from the
    // corner that names it to the next one, where two edges touch; and nothing for all other kinds.
    std::optional<Vec3> direction;
};

}  // namespace ecods
