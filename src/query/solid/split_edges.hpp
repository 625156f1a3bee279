// The triangles of a solid, edges divided where others that lie along them end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/solid/self_contacts.hpp"

namespace ecods {

// What a triangle was cut out of.
struct TriangleOrigin {
    static constexpr std::uint8_t none = 3;  // of a side that is inside the triangle

    std::uint32_t triangle;
    std::array<std::uint8_t, 3> sides;  // by side: the side of `triangle` that it is a part of, or none
};

struct SplitMesh {
    ProperMesh mesh;
    std::vector<TriangleOrigin> origins;  // by triangle, ascending
};

// Divides triangles without a new vertex, until edges are either one edge or share at most a point. `overlaps` has each
// two edges of the mesh that lie along each other. Zero-area triangles are left out. Cost: n log n in the overlaps, and
// a pass over the triangles.
SplitMesh split_edges(const ProperMesh& proper, std::span<const EdgeOverlap> overlaps);

}  // namespace ecods
