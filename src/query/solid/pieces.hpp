// Finds the pieces of a mesh: triangles that are joined over common vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Joins the vertices of triangles, by union-find. Vertices at equal coordinates count as one vertex if the mesh may be
// a triangle soup, which has three vertices a triangle.
class VertexPieces {
  public:
    // Works in `parents`, which must outlive this object.
    VertexPieces(const Mesh& mesh, std::vector<std::uint32_t>& parents);

    void join(const Triangle& corners);

    // Returns the vertex that stands for all vertices of the piece.
    std::uint32_t piece_of(std::uint32_t vertex);

  private:
    std::vector<std::uint32_t>& parents_;
};

// Returns the least triangle of each piece, in the order of the leaves of the shape's tree: neighbours in the list are
// near each other. Cost: some passes over vertices and triangles.
std::vector<std::uint32_t> find_pieces(const MeshShape& shape);

}  // namespace ecods
