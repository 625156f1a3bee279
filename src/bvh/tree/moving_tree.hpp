// A TreeAtEnds is the tree of a mesh at both ends of a motion. If the vertices move on straight lines, each to a place
// of its own, the tree at the end has the structure of the tree at the start, and other boxes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"

namespace ecods {

// A NodeAtEnds is a node or leaf at both ends of a motion. Both have the same triangles in the same lanes.
template <class Node>
struct NodeAtEnds {
    NodeAtEnds(const Node& at_start, const Node& at_end) noexcept : start(at_start), end(at_end), count(start.count) {}

    const Node &start, &end;
    std::uint32_t count;

    std::uint32_t lanes() const noexcept { return start.lanes(); }
};

// Refers to the trees of a mesh at both ends, which are the same tree if the mesh is rigid.
class TreeAtEnds {
  public:
    TreeAtEnds() = default;
    // Refers to one tree for both ends, or to a tree for each end. All trees must outlive this object.
    explicit TreeAtEnds(const MeshBvh& rigid) noexcept : TreeAtEnds(rigid, rigid) {}
    TreeAtEnds(const MeshBvh& start, const MeshBvh& end) noexcept : start_(&start), end_(&end) {}

    const MeshBvh& start() const noexcept { return *start_; }
    const MeshBvh& end() const noexcept { return *end_; }

    // Return a node or leaf of the tree at the start, with its counterpart at the end.
    NodeAtEnds<BvhNode> of(const BvhNode& node) const noexcept {
        return {node, end_->nodes[static_cast<std::size_t>(&node - start_->nodes.data())]};
    }
    NodeAtEnds<TreeLeaf> of(const TreeLeaf& leaf) const noexcept {
        return {leaf, end_->leaves[static_cast<std::size_t>(&leaf - start_->leaves.data())]};
    }

  private:
    const MeshBvh* start_ = nullptr;
    const MeshBvh* end_ = nullptr;
};

// Returns a tree for `mesh`, which must have the triangles of the tree's mesh and may have other vertices. The new tree
// has the structure of `tree`: each triangle stays in its leaf, and boxes are computed again. Cost: one pass over the
// triangles.
MeshBvh with_other_vertices(const MeshBvh& tree, const Mesh& mesh);

}  // namespace ecods
