// walk_two walks two trees of triangles at once, from their roots to the pairs of triangles that may matter.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/open_pair.hpp"
#include "simd/inline.hpp"

namespace ecods {

// Visits one pair of nodes: calls result() for pairs of triangles, or pushes pairs of children on the stack. Returns
// true if the walk should go on.
template <class Bound, class Result>
ECODS_ALWAYS_INLINE bool visit_two(const MeshBvh& a, const MeshBvh& b, const NodePair& top,
                                   std::vector<NodePair>& stack, Bound&& bound, Result&& result) {
    return with_nodes(a, b, top, [&](const auto& x, const auto& y) -> bool {
        using X = std::remove_cvref_t<decltype(x)>;
        using Y = std::remove_cvref_t<decltype(y)>;
        const auto found = bound(x, y);
        if constexpr (std::is_same_v<decltype(found), const TrianglePairs>) {
            for (LanePairs pairs(found.near); pairs.more(); pairs.next()) {
                if (!result(x.triangle[pairs.i()], y.triangle[pairs.j()], pairs.is_in(found.crossing))) return false;
            }
        } else if constexpr (are_leaves<X, Y>) {
            for (LanePairs pairs(found); pairs.more(); pairs.next()) {
                if (!result(x.triangle[pairs.i()], y.triangle[pairs.j()])) return false;
            }
        } else {
            const std::size_t before = stack.size();
            push_children(top, x, y, LanePairs(found),
                          [&](const NodePair& children, const auto&) { stack.push_back(children); });
            if constexpr (requires { bound.order(x, y, LanePairs(found), std::span(stack)); }) {
                bound.order(x, y, LanePairs(found), std::span(stack).subspan(before));
            }
        }
        return true;
    });
}

// Visits pairs of nodes of two trees depth-first.
//
// bound(x, y) is called once for each visited pair; x and y are a BvhNode or a TreeLeaf of the first and the second
// tree. bound() returns a mask of the pairs of lanes that may matter. If bound.order(x, y, pairs, children) exists for
// two nodes, it may reorder their pairs of children; the last one is visited next. result(i, j) is called for each pair
// of triangles that may matter, and returns true if the walk should go on. `stack` is scratch.
template <class Bound, class Result>
void walk_two(const MeshBvh& a, const MeshBvh& b, std::vector<NodePair>& stack, Bound&& bound, Result&& result) {
    stack.assign(1, NodePair{a.root, b.root});
    while (!stack.empty()) {
        const NodePair top = stack.back();
        stack.pop_back();
        if (!visit_two(a, b, top, stack, bound, result)) return;
    }
}

}  // namespace ecods
