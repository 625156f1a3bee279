// The walk of one tree of triangles, from its root to the leaves that matter.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "bvh/tree/mesh_bvh.hpp"

namespace ecods {

// Visits nodes depth first. `bound(x)`, x being a BvhNode or a TreeLeaf, returns the lanes that may matter, as bits.
// `result(triangle)` takes each triangle that is left, and returns whether the walk goes on. `stack` is working memory.
template <class Bound, class Result>
void walk_tree(const MeshBvh& tree, std::vector<TreeRef>& stack, Bound&& bound, Result&& result) {
    stack.assign(1, tree.root);
    while (!stack.empty()) {
        const TreeRef top = stack.back();
        stack.pop_back();
        if (top.is_leaf()) {
            const TreeLeaf& leaf = tree.leaves[top.index()];
            for (std::uint32_t lanes = bound(leaf); lanes != 0; lanes &= lanes - 1) {
                if (!result(leaf.triangle[static_cast<std::size_t>(std::countr_zero(lanes))])) return;
            }
        } else {
            const BvhNode& node = tree.nodes[top.index()];
            for (std::uint32_t lanes = bound(node); lanes != 0; lanes &= lanes - 1) {
                stack.push_back(node.child[static_cast<std::size_t>(std::countr_zero(lanes))]);
            }
        }
    }
}

}  // namespace ecods
