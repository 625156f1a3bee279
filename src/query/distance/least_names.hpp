// LeastNames finds the name of a vertex or an edge: the least triangle, among given triangles of a mesh, that has it,
// and the vertex's or edge's corner there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

class LeastNames {
  public:
    // Takes the given triangles of the mesh, in any order; duplicates are allowed. Cost: sorting the corners of these
    // triangles; other triangles are not read.
    LeastNames(const Mesh& mesh, std::vector<std::uint32_t> triangles);

    // Returns the vertex or edge `feature` with its least name: the least of the given triangles that has it, and the
    // least corner there. One of the given triangles must have the feature. A face is returned unchanged.
    Feature operator()(const Feature& feature) const;

  private:
    // A Place is the coordinates of a vertex as integer keys, which are ordered like doubles, and have a single zero
    // (base/double_key.hpp).
    using Place = std::array<std::int64_t, 3>;
    struct Vertex {
        Place place;
        std::uint32_t triangle, corner;
    };
    // An Edge has the indices of its ends in vertices_, the lesser first, and its least name.
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
