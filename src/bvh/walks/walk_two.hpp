// The walk of two trees of triangles at once, from their roots to the pairs of triangles that matter.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "bvh/axes/separating_axes.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "simd/inline.hpp"

namespace ecods {

struct NodePair {
    TreeRef a;
    TreeRef b;
};

// Pairs of lanes of two nodes or leaves: bit 8 j + i is lane i of the first and lane j of the second.
class LanePairs {
  public:
    explicit LanePairs(std::uint64_t bits) : bits_(bits) {}

    bool has_first(std::size_t i) const noexcept { return (bits_ >> i & lane_of_each) != 0; }
    bool has_second(std::size_t j) const noexcept { return (bits_ >> (tree_width * j) & all_of_one) != 0; }

    // From the first pair on: `for (; pairs.more(); pairs.next())` with i() and j().
    bool more() const noexcept { return bits_ != 0; }
    void next() noexcept { bits_ &= bits_ - 1; }
    std::size_t i() const noexcept { return static_cast<std::size_t>(std::countr_zero(bits_)) % tree_width; }
    std::size_t j() const noexcept { return static_cast<std::size_t>(std::countr_zero(bits_)) / tree_width; }
    bool is_in(std::uint64_t bits) const noexcept { return (bits_ & (0 - bits_) & bits) != 0; }

  private:
    static constexpr std::uint64_t all_of_one = 0xff, lane_of_each = 0x0101010101010101;

    std::uint64_t bits_;
};

// Visits one pair of nodes: gives pairs of triangles to `result`, or pushes pairs of children. Returns whether the walk
// goes on.
template <class Bound, class Result>
ECODS_ALWAYS_INLINE bool visit_two(const MeshBvh& a, const MeshBvh& b, const NodePair& top,
                                   std::vector<NodePair>& stack, Bound&& bound, Result&& result) {
    if (top.a.is_leaf() && top.b.is_leaf()) {
        const TreeLeaf& x = a.leaves[top.a.index()];
        const TreeLeaf& y = b.leaves[top.b.index()];
        const auto found = bound(x, y);
        if constexpr (std::is_same_v<decltype(found), const TrianglePairs>) {
            for (LanePairs pairs(found.near); pairs.more(); pairs.next()) {
                if (!result(x.triangle[pairs.i()], y.triangle[pairs.j()], pairs.is_in(found.crossing))) return false;
            }
        } else {
            for (LanePairs pairs(found); pairs.more(); pairs.next()) {
                if (!result(x.triangle[pairs.i()], y.triangle[pairs.j()])) return false;
            }
        }
    } else if (top.a.is_leaf()) {
        const BvhNode& y = b.nodes[top.b.index()];
        const LanePairs pairs(bound(a.leaves[top.a.index()], y));
        for (std::size_t j = 0; j < y.count; ++j) {
            if (pairs.has_second(j)) stack.push_back({top.a, y.child[j]});
        }
    } else if (top.b.is_leaf()) {
        const BvhNode& x = a.nodes[top.a.index()];
        const LanePairs pairs(bound(x, b.leaves[top.b.index()]));
        for (std::size_t i = 0; i < x.count; ++i) {
            if (pairs.has_first(i)) stack.push_back({x.child[i], top.b});
        }
    } else {
        const BvhNode& x = a.nodes[top.a.index()];
        const BvhNode& y = b.nodes[top.b.index()];
        const LanePairs pairs(bound(x, y));
        const std::size_t before = stack.size();
        for (LanePairs rest = pairs; rest.more(); rest.next()) {
            stack.push_back({x.child[rest.i()], y.child[rest.j()]});
        }
        bound.order(x, y, pairs, std::span(stack).subspan(before));
    }
    return true;
}

// Visits pairs of nodes depth first.
//
// `bound(x, y)` is asked once for each pair visited, x and y being a BvhNode or a TreeLeaf of the first and the second
// tree, and returns as bits which pairs of lanes may matter. `bound.order(x, y, pairs, children)`, for two nodes, may
// reorder their pairs of children, of which the last is visited next. `result(i, j)` takes each pair of triangles that
// is left, and returns whether the walk goes on. `stack` is working memory.
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
