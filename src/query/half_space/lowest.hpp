// Finds the lowest vertices of a posed mesh above a half space.
#pragma once

#include <cstdint>
#include <utility>

#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "query/half_space/heights.hpp"

namespace ecods::half_spaces {

// A Corner is a corner of a triangle, and the vertex there.
struct Corner {
    std::uint32_t triangle, index, vertex;

    Feature feature() const noexcept { return {Feature::Kind::vertex, triangle, index}; }
    std::pair<std::uint32_t, std::uint32_t> name() const noexcept { return {triangle, index}; }
};

// plane_feature is the feature that results name for a half space: its plane, as the face of triangle 0.
inline constexpr Feature plane_feature{Feature::Kind::face, 0, 0};

// Returns the corner with the least height; if several have it, the first by triangle and corner.
Corner find_lowest(const MeshShape& shape, const Heights& heights, QueryMemory& memory);

// Returns true if a vertex of a triangle has a height of at most zero. This test is cheaper than find_lowest().
bool reaches_plane(const MeshShape& shape, const Heights& heights, QueryMemory& memory);

}  // namespace ecods::half_spaces
