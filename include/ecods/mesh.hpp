// A Mesh is a triangle mesh. It holds vertices and triangles, which are triples of vertex indices. (Box3D: b3MeshData;
// trimesh: Trimesh. FCL's and Coal's BVHModel and Parry's TriMesh also have the tree, as MeshShape does.)
//
// Example: verify/examples/how_do_i, make_a_mesh().
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <ranges>
#include <span>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// A Triangle is three indices of vertices. No answer depends on their order. Indices may repeat: such a triangle is the
// segment or the point that it spans, and so is any other triangle of zero area.
using Triangle = std::array<std::uint32_t, 3>;

// NumbersOf is satisfied by numbers of one of two types, stored contiguously: a std::vector, a std::span, an array.
template <class Range, class First, class Second>
concept NumbersOf = std::ranges::contiguous_range<const Range> && std::ranges::sized_range<const Range> &&
    (std::same_as<std::ranges::range_value_t<Range>, First> || std::same_as<std::ranges::range_value_t<Range>, Second>);

// A Mesh is a soup of closed triangles: immutable, and shared by any number of bodies, worlds and threads. It need not
// be closed, connected or manifold. It is a surface: a small body inside a hollow one does not touch it. Vertices that
// no triangle uses do not belong to it.
class ECODS_API Mesh {
  public:
    // Moves the lists into the mesh. Throws InvalidMesh. Cost: one pass.
    static std::shared_ptr<const Mesh> create(std::vector<Vec3> vertices, std::vector<Triangle> triangles);

    // Copies the caller's numbers: three coordinates of each vertex, `stride` numbers apart, and three indices of each
    // triangle. The numbers after the last vertex's coordinates may be left out. Floats are converted exactly. Throws
    // InvalidMesh, also if the numbers do not make whole vertices and triangles. An index beyond 32 bits is refused
    // like any other index that is too large.
    template <NumbersOf<float, double> Coordinates, NumbersOf<std::uint32_t, std::uint64_t> Indices>
    static std::shared_ptr<const Mesh> create(const Coordinates& coordinates, const Indices& indices,
                                              std::size_t stride = 3) {
        return create_from(std::span<const std::ranges::range_value_t<Coordinates>>(coordinates),
                           std::span<const std::ranges::range_value_t<Indices>>(indices), stride);
    }

    std::span<const Vec3> vertices() const noexcept { return vertices_; }
    std::span<const Triangle> triangles() const noexcept { return triangles_; }

    // Returns true if every vertex belongs to a triangle.
    bool uses_all_vertices() const noexcept { return uses_all_vertices_; }

    // Returns a hash of coordinates (bits) and indices, the same on every machine; -0.0 counts as 0.0.
    std::uint64_t digest() const noexcept { return digest_; }

  private:
    static std::shared_ptr<const Mesh> create_from(std::span<const double> coordinates,
                                                   std::span<const std::uint32_t> indices, std::size_t stride);
    static std::shared_ptr<const Mesh> create_from(std::span<const double> coordinates,
                                                   std::span<const std::uint64_t> indices, std::size_t stride);
    static std::shared_ptr<const Mesh> create_from(std::span<const float> coordinates,
                                                   std::span<const std::uint32_t> indices, std::size_t stride);
    static std::shared_ptr<const Mesh> create_from(std::span<const float> coordinates,
                                                   std::span<const std::uint64_t> indices, std::size_t stride);
    Mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles);

    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
    bool uses_all_vertices_ = false;
    std::uint64_t digest_ = 0;
};

}  // namespace ecods
