// A ProperMesh marks the triangles of positive area of a mesh, and gives corners with equal coordinates the same index.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods {

struct ProperMesh {
    // Holds the given mesh, or a copy in which each corner is replaced by the least vertex with the same coordinates.
    std::shared_ptr<const Mesh> mesh;
    // Has an entry for each triangle: true if its area is positive. The list is empty if all areas are positive.
    std::vector<std::uint8_t> has_area;

    bool is_proper(std::size_t triangle) const noexcept { return has_area.empty() || has_area[triangle] != 0; }
};

// Returns, by vertex, the least vertex with the same coordinates. Returns an empty list if no two vertices have the
// same coordinates.
std::vector<std::uint32_t> least_equals(std::span<const Vec3> vertices);

// Returns the indices of the points, ascending; of points with equal coordinates, only the first.
std::vector<std::uint32_t> distinct(std::span<const Vec3> points);

// Replaces corners by the least vertices with the same coordinates, and finds the triangles of positive area. Cost: one
// pass over the vertices, with a hash table, and one over the triangles.
ProperMesh find_proper(std::shared_ptr<const Mesh> mesh);

// Returns true if the three points are not on one line. Exact.
bool have_area(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

// Returns the order of two points by x, then y, then z, as a negative number, zero or a positive number. So points of
// one line are ordered along the line. Coordinates are compared by their bits, so a floating-point mode that treats
// subnormals as zero changes nothing.
int compare_points(const Vec3& a, const Vec3& b) noexcept;

}  // namespace ecods
