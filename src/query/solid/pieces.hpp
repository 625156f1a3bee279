// Finds the pieces of a mesh: sets of triangles that are connected over common vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// VertexPieces joins the vertices of triangles, by union-find. If the mesh may be a triangle soup, which has three
// vertices a triangle, vertices with equal coordinates count as one vertex.
class VertexPieces {
  public:
    // Stores the union-find parents in `parents`, which must outlive this object.
    VertexPieces(const Mesh& mesh, std::vector<std::uint32_t>& parents);

    void join(const Triangle& corners);

    // Returns the union-find root of the vertex, which stands for all vertices of the piece.
    std::uint32_t piece_of(std::uint32_t vertex);

  private:
    std::vector<std::uint32_t>& parents_;
};

// Returns the least triangle of each piece, in the order of the leaves of the shape's tree, so that neighbors in the
// list are near each other. Cost: some passes over vertices and triangles.
std::vector<std::uint32_t> find_pieces(const MeshShape& shape);

}  // namespace ecods
