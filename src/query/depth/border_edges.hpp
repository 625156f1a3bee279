// Finds the border of triangles that are removed from a surface.
#pragma once

#include <array>
#include <cstdint>

#include "simd/inline.hpp"

namespace ecods::depths {

// An edge: its first end in the upper 32 bits, its second end in the lower ones.
using BorderEdge = std::uint64_t;

// Adds the edges of a triangle to a list of `count` edges, and returns the new count, which is at most count + 3. An
// edge between two of the triangles comes in both directions, and cancels.
ECODS_ALWAYS_INLINE std::uint32_t add_edges(const std::array<std::uint32_t, 3>& corners, BorderEdge* border,
                                            std::uint32_t count) noexcept {
    for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t from = corners[c], to = corners[c == 2 ? 0 : c + 1];
        const BorderEdge edge = BorderEdge{from} << 32 | to, twin = BorderEdge{to} << 32 | from;
        std::uint32_t k = 0;
        while (k < count && border[k] != twin) ++k;
        if (k < count) {
            border[k] = border[--count];
        } else {
            border[count++] = edge;
        }
    }
    return count;
}

}  // namespace ecods::depths
