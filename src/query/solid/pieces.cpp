#include "query/solid/pieces.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "query/shape/mesh_tree.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

VertexPieces::VertexPieces(const Mesh& mesh, std::vector<std::uint32_t>& parents) : parents_(parents) {
    const std::size_t count = mesh.vertices().size();
    parents_.clear();
    if (count >= 3 * mesh.triangles().size()) parents_ = least_equals(mesh.vertices());
    if (!parents_.empty()) return;
    parents_.resize(count);
    std::iota(parents_.begin(), parents_.end(), 0u);
}

void VertexPieces::join(const Triangle& corners) {
    const std::uint32_t first = piece_of(corners[0]);
    parents_[piece_of(corners[1])] = first;
    parents_[piece_of(corners[2])] = first;
}

std::uint32_t VertexPieces::piece_of(std::uint32_t vertex) {
    while (parents_[vertex] != vertex) vertex = parents_[vertex] = parents_[parents_[vertex]];
    return vertex;
}

std::vector<std::uint32_t> find_pieces(const MeshShape& shape) {
    constexpr std::uint32_t none = ~std::uint32_t{0};
    const auto triangles = shape.mesh().triangles();
    std::vector<std::uint32_t> parents;
    VertexPieces pieces(shape.mesh(), parents);
    for (const Triangle& corners : triangles) pieces.join(corners);
    std::vector<std::uint32_t> least(parents.size(), none);  // by root: least triangle; none once listed
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        std::uint32_t& known = least[pieces.piece_of(triangles[i][0])];
        known = std::min(known, i);
    }
    std::vector<std::uint32_t> result;
    for (const TreeLeaf& leaf : MeshShapeAccess::tree(shape).boxes.leaves) {
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            const std::uint32_t corner = triangles[leaf.triangle[lane]][0];
            const std::uint32_t first = std::exchange(least[pieces.piece_of(corner)], none);
            if (first != none) result.push_back(first);
        }
    }
    return result;
}

}  // namespace ecods
