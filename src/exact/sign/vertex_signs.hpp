// VertexSigns gives signs of many determinants of one mesh's vertices in its own coordinates.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/pose.hpp"
#include "exact/sign/filter_bound.hpp"

namespace ecods::exact {

// Returns bounds for all determinants of points whose coordinates have no error. Needs at least one point.
DeterminantBounds own_bounds(std::span<const Vec3> points) noexcept;

// Decides by one bound for all vertices. If that leaves a sign open, looks for a reason without arithmetic that the
// points are in one plane, as in a face across an axis; then asks the exact predicate.
class VertexSigns {
  public:
    // The vertices must outlive this object. Cost: one pass over them.
    explicit VertexSigns(std::span<const Vec3> vertices) noexcept
        : vertices_(vertices), bounds_(own_bounds(vertices)) {}

    // Returns ecods::orient3d of the vertices: exact.
    int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept;

    // Returns the sign of a component of (b - a) x (c - a): exact.
    int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const noexcept;

  private:
    Point point(std::uint32_t i) const noexcept { return {vertices_[i][0], vertices_[i][1], vertices_[i][2]}; }

    std::span<const Vec3> vertices_;
    DeterminantBounds bounds_;
};

}  // namespace ecods::exact
