// Where two bodies are closest to each other, and on which of their features (distance.hpp says how to ask).
#pragma once

#include <cstdint>
#include <iosfwd>

#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

// A vertex, an edge or a face of a mesh, named by a triangle that it is part of and the least corner of that triangle
// which names it: corner 0, 1 or 2 is the vertex; the edge goes from `corner` to the next one; of a face it is 0.
struct Feature {
    enum class Kind : std::uint8_t { vertex, edge, face };

    Kind kind = Kind::vertex;
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    friend bool operator==(const Feature&, const Feature&) = default;
};

// Which features hold the closest points.
enum class ClosestKind : std::uint8_t { vertex_vertex, vertex_edge, vertex_face, edge_edge, intersecting };

ECODS_API std::ostream& operator<<(std::ostream& out, ClosestKind kind);

// Two closest points of two bodies, or of a triangle of each, and what they are on.
//
// The features are those of lowest dimension that hold the points: a vertex, the open edge, or the open face. Where
// several pairs of features have exactly that distance, the first is given: by kind in the order of ClosestKind, then
// by the triangle and corner of `a`, then of `b`, then the one whose feature of `a` is the vertex. Edges meet inside
// both where they are not parallel; parallel ones have a vertex at the least distance. An edge of a zero-area triangle
// is one if its ends differ. `intersecting`: the bodies share a point. Then both features are faces, of the least pair
// of triangles that share a point, and both points are the lexicographically least corner of what these two share.
struct ClosestPoints {
    double distance = 0;  // rounded once
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;
    Vec3 point_a, point_b;  // each coordinate rounded once; a zero is +0

    TrianglePair triangles() const noexcept { return {a.triangle, b.triangle}; }
};

}  // namespace ecods
