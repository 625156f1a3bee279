// What a body is made of.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// Three indices of vertices. Their order does not matter to any answer. Indices may repeat: such a triangle
// is the segment or the point that it spans, and so is any other triangle of zero area.
using Triangle = std::array<std::uint32_t, 3>;

// A soup of closed triangles: immutable once made, shared by any number of bodies, worlds and threads. It
// need not be closed, connected or manifold, and is a surface: a small body inside a hollow one does not touch
// it. Vertices that no triangle uses do not belong to it.
class ECODS_API Mesh {
  public:
    // Takes the lists over. Throws EmptyMesh, InvalidVertex, InvalidIndex or MeshTooLarge. Cost: one pass.
    static std::shared_ptr<const Mesh> create(std::vector<Vec3> vertices, std::vector<Triangle> triangles);

    std::span<const Vec3> vertices() const noexcept { return vertices_; }
    std::span<const Triangle> triangles() const noexcept { return triangles_; }

    // Whether every vertex belongs to a triangle.
    bool uses_all_vertices() const noexcept { return uses_all_vertices_; }

    // A hash of coordinates (bits) and indices, the same on every machine; -0.0 counts as 0.0.
    std::uint64_t digest() const noexcept { return digest_; }

  private:
    Mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles);

    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    bool uses_all_vertices_ = false;
    std::uint64_t digest_ = 0;
};

}  // namespace ecods
