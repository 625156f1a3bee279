// walk_self walks a tree of triangles against itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "bvh/walks/walk_two.hpp"

namespace ecods {

// Marks the pairs of lanes i < j, as bits 8 j + i. For a node paired with itself, these pairs are all pairs of
// different lanes, once each.
inline constexpr std::uint64_t lesser_lane_first = [] {
    std::uint64_t bits = 0;
    for (std::size_t j = 0; j < tree_width; ++j) bits |= ((std::uint64_t{1} << j) - 1) << (tree_width * j);
    return bits;
}();

// Returns the mask that `bound` returns; for a node paired with itself, only the pairs of lanes i < j in that mask. The
// struct has no order(), so children are not reordered.
template <class Bound>
struct SelfBound {
    Bound& bound;

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) const {
        return bound(x, y) & (is_same(x, y) ? lesser_lane_first : ~std::uint64_t{0});
    }

  private:
    template <class X, class Y>
    static bool is_same(const X& x, const Y& y) noexcept {
        return static_cast<const void*>(&x) == static_cast<const void*>(&y);
    }
};

// Visits pairs of nodes depth-first. result(i, j) is called for each pair of different triangles that `bound` does not
// exclude, once, with i and j in either order. result() returns true if the walk should go on. `bound` and `stack` are
// as for walk_two().
template <class Bound, class Result>
void walk_self(const MeshBvh& tree, std::vector<NodePair>& stack, Bound&& bound, Result&& result) {
    stack.assign(1, NodePair{tree.root, tree.root});
    const SelfBound<std::remove_reference_t<Bound>> self{bound};
    while (!stack.empty()) {
        const NodePair top = stack.back();
        stack.pop_back();
        // For a node with itself, each child with itself is pushed before the pairs of different children.
        if (!top.a.is_leaf() && !top.b.is_leaf() && top.a.index() == top.b.index()) {
            const BvhNode& x = tree.nodes[top.a.index()];
            for (std::size_t i = 0; i < x.count; ++i) stack.push_back({x.child[i], x.child[i]});
        }
        if (!visit_two(tree, tree, top, stack, self, result)) return;
    }
}

}  // namespace ecods
