// add_edges() collects the border edges of the region that a set of removed triangles leaves in a surface.
#pragma once

#include <array>
#include <cstdint>

#include "simd/inline.hpp"

namespace ecods::depths {

// A BorderEdge is a directed edge: its first end is in the upper 32 bits, its second end in the lower 32 bits.
using BorderEdge = std::uint64_t;

// Adds the edges of a triangle to the `count` edges of `border`, and returns the new count, at most count + 3. An edge
// cancels with the same edge in the opposite direction, so an edge between two removed triangles is not in the border.
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
