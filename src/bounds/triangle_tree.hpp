// A binary tree of boxes over the triangles of a mesh, in the mesh's own frame.
#pragma once

#include <cstdint>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods {

// A box with its children (inner node) or its triangles (leaf).
struct TreeNode {
    Vec3 center;
    Vec3 half;            // the box is |v - center| <= half on each axis, and contains its triangles
    std::uint32_t begin;  // inner: index of the first child, the second follows it; leaf: into `order`
    std::uint32_t count;  // triangles of a leaf; 0 for an inner node

    bool is_leaf() const noexcept { return count != 0; }
};

struct TriangleTree {
    static constexpr std::uint32_t leaf_size = 2;

    std::vector<TreeNode> nodes;       // the root first
    std::vector<std::uint32_t> order;  // triangle indices, a leaf's next to each other
};

// Halves the triangles at the median of their centres along the longest axis. Cost: n log n; depth: log2 n.
TriangleTree build_triangle_tree(const Mesh& mesh);

}  // namespace ecods
