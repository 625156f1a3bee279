// Divides the edges of a solid's triangles where other edges that lie along them end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/solid/self_contacts.hpp"

namespace ecods {

// Names the triangle that a triangle was cut out of.
struct TriangleOrigin {
    static constexpr std::uint8_t none = 3;  // for a side inside the triangle

    std::uint32_t triangle;
    std::array<std::uint8_t, 3> sides;  // by side: the side of `triangle` that contains it, or none
};

struct SplitMesh {
    ProperMesh mesh;
    std::vector<TriangleOrigin> origins;  // by triangle of `mesh`, ascending
};

// Divides triangles, without new vertices, until two edges are either one edge or share at most a point. `overlaps`
// lists all pairs of edges that share a segment without being one. Triangles of zero area are left out. Cost: n log n
// in the number of overlaps, and a pass over the triangles.
SplitMesh split_edges(const ProperMesh& proper, std::span<const EdgeOverlap> overlaps);

}  // namespace ecods
