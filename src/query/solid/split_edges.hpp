// Divides edges of a solid's triangles at the ends of other edges that lie along them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/solid/self_contacts.hpp"

namespace ecods {

// A TriangleOrigin names the triangle that contains a triangle as a piece.
struct TriangleOrigin {
    static constexpr std::uint8_t none = 3;  // for a side that is inside `triangle`

    std::uint32_t triangle;
    std::array<std::uint8_t, 3> sides;  // by side of the piece: side of `triangle` that contains it, or none
};

struct SplitMesh {
    ProperMesh mesh;
    std::vector<TriangleOrigin> origins;  // by triangle of `mesh`, ascending
};

// Divides triangles, without new vertices, until any two sides are the same edge or share at most a point. `overlaps`
// must list all pairs of sides that share a segment but are different edges. Triangles of zero area are left out. Cost:
// n log n in the number of overlaps, and a pass over the triangles.
SplitMesh split_edges(const ProperMesh& proper, std::span<const EdgeOverlap> overlaps);

}  // namespace ecods
