// The walk of a tree of triangles against itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/walk_two.hpp"

namespace ecods {

// The pairs of lanes i < j: of a node with itself each pair of different lanes once.
inline constexpr std::uint64_t lesser_lane_first = [] {
    std::uint64_t bits = 0;
    for (std::size_t j = 0; j < tree_width; ++j) bits |= ((std::uint64_t{1} << j) - 1) << (tree_width * j);
    return bits;
}();

// Visits pairs of nodes depth first, so that `result(i, j)` takes each pair of different triangles that `bound` leaves
// once, in either order; it returns whether the walk goes on. `bound` and `stack` are as for walk_two.
template <class Bound, class Result>
void walk_self(const MeshBvh& tree, std::vector<NodePair>& stack, Bound&& bound, Result&& result) {
    stack.assign(1, NodePair{tree.root, tree.root});
    while (!stack.empty()) {
        const NodePair top = stack.back();
        stack.pop_back();
        const bool is_same = top.a.is_leaf() == top.b.is_leaf() && top.a.index() == top.b.index();
        if (top.a.is_leaf() && top.b.is_leaf()) {
            const TreeLeaf& x = tree.leaves[top.a.index()];
            const TreeLeaf& y = tree.leaves[top.b.index()];
            const std::uint64_t lanes = bound(x, y) & (is_same ? lesser_lane_first : ~std::uint64_t{0});
            for (LanePairs pairs(lanes); pairs.more(); pairs.next()) {
                if (!result(x.triangle[pairs.i()], y.triangle[pairs.j()])) return;
            }
        } else if (is_same) {
            const BvhNode& x = tree.nodes[top.a.index()];
            for (std::size_t i = 0; i < x.count; ++i) stack.push_back({x.child[i], x.child[i]});
            for (LanePairs pairs(bound(x, x) & lesser_lane_first); pairs.more(); pairs.next()) {
                stack.push_back({x.child[pairs.i()], x.child[pairs.j()]});
            }
        } else if (top.a.is_leaf()) {
            const BvhNode& y = tree.nodes[top.b.index()];
            const LanePairs pairs(bound(tree.leaves[top.a.index()], y));
            for (std::size_t j = 0; j < y.count; ++j) {
                if (pairs.has_second(j)) stack.push_back({top.a, y.child[j]});
            }
        } else if (top.b.is_leaf()) {
            const BvhNode& x = tree.nodes[top.a.index()];
            const LanePairs pairs(bound(x, tree.leaves[top.b.index()]));
            for (std::size_t i = 0; i < x.count; ++i) {
                if (pairs.has_first(i)) stack.push_back({x.child[i], top.b});
            }
        } else {
            const BvhNode& x = tree.nodes[top.a.index()];
            const BvhNode& y = tree.nodes[top.b.index()];
            for (LanePairs pairs(bound(x, y)); pairs.more(); pairs.next()) {
                stack.push_back({x.child[pairs.i()], y.child[pairs.j()]});
            }
        }
    }
}

}  // namespace ecods
