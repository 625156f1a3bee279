// Finds the least triangle and corner that name a vertex or an edge, among given triangles of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

class LeastNames {
  public:
    // `triangles` may be in any order and repeat. Cost: sorting their corners; the rest of the mesh is not read.
    LeastNames(const Mesh& mesh, std::vector<std::uint32_t> triangles);

    // The least triangle and corner, among the given triangles, that name the vertex or edge `feature`. It must be a
    // feature of one of them. A face keeps its name.
    Feature operator()(const Feature& feature) const;

  private:
    // The coordinates of a vertex, as keys in the order of doubles (base/double_key.hpp), which has one zero.
    using Place = std::array<std::int64_t, 3>;
    struct Vertex {
        Place place;
        std::uint32_t triangle, corner;
    };
    // An edge; its ends are indices of vertices_, the lesser first.
    struct Edge {
        std::array<std::uint32_t, 2> ends;
        std::uint32_t triangle, corner;
    };

    Place place_of(std::uint32_t triangle, std::uint32_t corner) const;
    std::uint32_t vertex_of(std::uint32_t triangle, std::uint32_t corner) const;
    std::array<std::uint32_t, 2> ends_of(std::uint32_t triangle, std::uint32_t corner) const;

    const Mesh& mesh_;
    std::vector<Vertex> vertices_;  // ascending by place, unique
    std::vector<Edge> edges_;       // ascending by ends, unique
};

}  // namespace ecods
