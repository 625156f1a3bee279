// Where two bodies meet, and which of their features nearly do. No World is needed.
//
// Numbers are those of the real points, as in distance.hpp; thread safety as in intersection.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/intersection.hpp"

namespace ecods {

// What two triangles share: a point (one corner), a segment (two), or a convex polygon of a common plane.
struct SharedSet {
    std::size_t corner_count = 0;  // 1 to 6; 0 if they share nothing
    // Ascending by the coordinates of the real points, the first axis first. Each coordinate rounded once; a zero is
    // +0.
    std::array<Vec3, 6> all_corners{};
    // A unit vector, each coordinate rounded once, where one face or two edges define it: the normal of a face if what
    // is shared lies in a vertex or an edge of one triangle and inside the face of the other, or in both faces, of
    // which the first triangle's counts; the product of two edges, the first triangle's first, that meet in one point
    // inside both. The normal of corners a, b and c is (b - a) x (c - a).
    std::optional<Vec3> normal;

    std::span<const Vec3> corners() const noexcept { return std::span(all_corners).first(corner_count); }
};

struct TriangleIntersection {
    TrianglePair triangles;
    SharedSet shared;
};

// Every pair of triangles that share a point, ascending, with what they share.
// Cost: that of intersecting_triangles, and some microseconds a pair.
ECODS_API std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                          QueryMemory& memory);

// Two features that hold closest points of a pair of triangles, and the way from one to the other.
struct CloseFeatures {
    ClosestPoints closest;
    // The unit vector from the point of a to that of b, each coordinate rounded once; none where the triangles
    // intersect.
    std::optional<Vec3> direction;
};

// The features of close_triangles, each pair of features once, with the least pair of triangles that have it, ascending
// by that. Corners of a mesh at equal coordinates are one vertex: features are the same if their corners are. Throws
// InvalidDistance if d is negative, NaN or infinity.
ECODS_API std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                                    QueryMemory& memory);

}  // namespace ecods
