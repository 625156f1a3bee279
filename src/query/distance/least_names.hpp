// Vertices and edges of a mesh by the least triangle and corner that name them, from the triangles that matter alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

class LeastNames {
  public:
    // `triangles` of the mesh, in any order and any number of times.
    // Cost: that of sorting their corners. Nothing is read of the rest of the mesh.
    LeastNames(const Mesh& mesh, std::vector<std::uint32_t> triangles);

    // The least triangle and corner among the triangles that are the same vertex or edge as `feature`, which is of one
    // of them. A face stays as it is.
    Feature operator()(const Feature& feature) const;

  private:
    // Coordinates by the order of doubles (base/double_key.hpp), in which both zeros are one.
    using Place = std::array<std::int64_t, 3>;
    struct Vertex {
        Place place;
        std::uint32_t triangle, corner;
    };
    // Ends are indices of vertices_, the lesser first.
    struct Edge {
        std::array<std::uint32_t, 2> ends;
        std::uint32_t triangle, corner;
    };

    Place place_of(std::uint32_t triangle, std::uint32_t corner) const;
    std::uint32_t vertex_of(std::uint32_t triangle, std::uint32_t corner) const;
    std::array<std::uint32_t, 2> ends_of(std::uint32_t triangle, std::uint32_t corner) const;

    const Mesh& mesh_;
    std::vector<Vertex> vertices_;  // ascending by place, each once
    std::vector<Edge> edges_;       // ascending by ends, each once
};

}  // namespace ecods
