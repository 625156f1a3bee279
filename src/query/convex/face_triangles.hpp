// FaceTriangles lists, for each face of a convex solid's hull, the triangles of the solid's mesh in that face.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ecods/shape.hpp"

namespace ecods::convex {

class FaceTriangles {
  public:
    explicit FaceTriangles(const ConvexSolid& solid);

    // Returns true if each vertex of the mesh is a vertex of the hull, and each triangle has an area. Then each edge of
    // the hull is an edge of the mesh, and edges of the mesh inside a face join two vertices of the face.
    bool is_plain() const noexcept { return !first_.empty(); }
    // Returns the triangles of a face, ascending. Call only if is_plain().
    std::span<const std::uint32_t> of(std::uint32_t face) const noexcept {
        return std::span(triangles_).subspan(first_[face], first_[face + 1] - first_[face]);
    }

  private:
    std::vector<std::uint32_t> first_, triangles_;
};

}  // namespace ecods::convex
