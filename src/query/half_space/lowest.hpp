// Finds the lowest vertices of a posed mesh above a half space.
#pragma once

#include <cstdint>
#include <utility>

#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "query/half_space/heights.hpp"

namespace ecods::half_spaces {

// A corner of a triangle, and the vertex there.
struct Corner {
    std::uint32_t triangle, index, vertex;

    Feature feature() const noexcept { return {Feature::Kind::vertex, triangle, index}; }
    std::pair<std::uint32_t, std::uint32_t> name() const noexcept { return {triangle, index}; }
};

// The feature of a half space that answers name: its plane.
inline constexpr Feature plane_feature{Feature::Kind::face, 0, 0};

// Returns a corner of the least height: of all these, the first by triangle and corner.
Corner find_lowest(const MeshShape& shape, const Heights& heights, QueryMemory& memory);

// True if a vertex of a triangle has a height of at most zero. Cheaper than the lowest one.
bool reaches_plane(const MeshShape& shape, const Heights& heights, QueryMemory& memory);

}  // namespace ecods::half_spaces
