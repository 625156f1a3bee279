// VertexSigns computes signs of many determinants of one mesh's vertices, in the mesh's own coordinates.
#pragma once

#include <cstdint>
#include <span>

#include "ecods/pose.hpp"
#include "exact/sign/filter_bound.hpp"

namespace ecods::exact {

// Returns error bounds of all determinants of points whose coordinates are exact. There must be at least one point.
DeterminantBounds own_bounds(std::span<const Vec3> points) noexcept;

// VertexSigns uses one error bound for all vertices. If the bound does not decide a sign, it tests first without
// arithmetic if the points are obviously in one plane, for example in a face perpendicular to an axis, and then calls
// the exact predicate.
class VertexSigns {
  public:
    // The vertices must outlive this object. Cost: one pass over them.
    explicit VertexSigns(std::span<const Vec3> vertices) noexcept
        : vertices_(vertices), bounds_(own_bounds(vertices)) {}

    // Returns the exact sign of det(b - a, c - a, d - a) for four vertices, as ecods::orient3d does.
    int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept;

    // Returns the exact sign of component `axis` of (b - a) x (c - a).
    int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const noexcept;

  private:
    Point point(std::uint32_t i) const noexcept { return {vertices_[i][0], vertices_[i][1], vertices_[i][2]}; }

    std::span<const Vec3> vertices_;
    DeterminantBounds bounds_;
};

}  // namespace ecods::exact
