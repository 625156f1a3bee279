// Signs of vertices of one mesh in its own coordinates, where many are asked for.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/pose.hpp"
#include "exact/sign/filter_bound.hpp"

namespace ecods::exact {

// Bounds for all determinants of some points, whose coordinates have no error. At least one point.
DeterminantBounds own_bounds(std::span<const Vec3> points) noexcept;

// One bound serves all vertices. Where it does not decide, points are first looked at for what shows without arithmetic
// that they are in one plane, as those of a face across an axis are; then the exact predicate decides.
class VertexSigns {
  public:
    // The vertices must outlive it. Cost: one pass over them.
    explicit VertexSigns(std::span<const Vec3> vertices) noexcept
        : vertices_(vertices), bounds_(own_bounds(vertices)) {}

    // As ecods::orient3d: exact.
    int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept;

    // The sign of a component of (b - a) x (c - a): exact.
    int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const noexcept;

  private:
    Point point(std::uint32_t i) const noexcept { return {vertices_[i][0], vertices_[i][1], vertices_[i][2]}; }

    std::span<const Vec3> vertices_;
    DeterminantBounds bounds_;
};

}  // namespace ecods::exact
