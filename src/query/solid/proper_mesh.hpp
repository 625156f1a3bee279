// The triangles of positive area of a mesh, corners at equal coordinates having one index.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods {

struct ProperMesh {
    // As it was given, or a copy in which corners name the least of the vertices with their coordinates.
    std::shared_ptr<const Mesh> mesh;
    // By triangle: whether its area is positive. Empty if every area is.
    std::vector<std::uint8_t> has_area;

    bool is_proper(std::size_t triangle) const noexcept { return has_area.empty() || has_area[triangle] != 0; }
};

// By vertex, the least one at its coordinates; empty if no two are at the same.
std::vector<std::uint32_t> least_equals(std::span<const Vec3> vertices);

// Cost: one pass over the vertices, with a hash table, and one over the triangles.
ProperMesh find_proper(std::shared_ptr<const Mesh> mesh);

// Whether three points are not on one line: exact.
bool have_area(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

// The order of points by x, then y, then z: negative, zero or positive. On a line it is the order along the line. Bits
// are compared, so a mode that takes subnormals for zero does not matter.
int compare_points(const Vec3& a, const Vec3& b) noexcept;

}  // namespace ecods
