// The oracle's solids: what include/ecods/solid.hpp promises, in rational numbers and over all triangles.
//
// Exact as oracle.hpp promises. Nothing of the library's method is used. Where the library takes signs around shared
// segments, points are constructed here: the triangles of both surfaces are cut into pieces along the planes of the
// others, and a point of each piece, moved to either side by as little as need be, is in a solid if a line through it
// crosses the solid's surface an odd number of times beyond. Every open region of space less both surfaces has a piece
// on its border, so this finds every region that there is.
//
// Cost: about 40 us a piece, and there are some dozens of them for two boxes. Answers for meshes that bound no solid
// mean nothing, or throw std::logic_error.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/results.hpp"
#include "oracle/distance.hpp"

namespace ecods::oracle {

// The edge from this corner of the triangle to the next.
struct CornerEdge {
    std::uint32_t triangle = 0;
    std::uint32_t corner = 0;

    friend bool operator==(const CornerEdge&, const CornerEdge&) = default;
};

// The first edge, of triangles of positive area, that an odd number of sides are, with an end that is the end of an odd
// number of sides along its line. None, if on every line all but finitely many points are on an even number of sides:
// the mesh is closed.
std::optional<CornerEdge> open_edge(const Mesh& mesh);

// True if no triangle has a positive area: the mesh then bounds the empty set.
bool bounds_nothing(const Mesh& mesh);

// All pairs of triangles of positive area that share a segment or more which is not a side of both, ascending.
std::vector<TrianglePair> self_intersections(const Mesh& mesh);

// As ecods::Side, in its order.
enum class PointSide { outside, on, inside };

struct PointLocation {
    PointSide side = PointSide::outside;
    NamedFeature feature = {};  // if on
};

PointLocation locate(const Vec3& point, const Soup& solid);
// Whether a piece of the surface, of triangles that are joined over equal corners, begins in or on the solid: of
// surfaces that share no point, whether a part of the first is inside the second. One corner of a piece is looked at.
bool has_piece_inside(const Soup& surface, const Soup& solid);

Relation solid_relation(const Soup& a, const Soup& b);
Relation surface_relation(const Soup& surface, const Soup& solid);

}  // namespace ecods::oracle
