// open_pair opens a pair of nodes of two trees: it distinguishes the four cases of nodes and leaves, and lists the
// pairs of children.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "bvh/tree/mesh_bvh.hpp"
#include "simd/inline.hpp"

namespace ecods {

// Names a node or leaf of each of two trees.
struct NodePair {
    TreeRef a;
    TreeRef b;
};

// Holds a set of pairs of lanes of two nodes or leaves: bit 8 j + i is for lane i of the first and lane j of the
// second.
class LanePairs {
  public:
    explicit LanePairs(std::uint64_t bits) : bits_(bits) {}

    // of_first() returns the pairs whose first lane is i, and of_second() the pairs whose second lane is j.
    LanePairs of_first(std::size_t i) const noexcept { return LanePairs(bits_ & lane_of_each << i); }
    LanePairs of_second(std::size_t j) const noexcept { return LanePairs(bits_ & all_of_one << (tree_width * j)); }

    // Iterate by `for (; pairs.more(); pairs.next())`: i() and j() are the lanes of the current pair.
    bool more() const noexcept { return bits_ != 0; }
    void next() noexcept { bits_ &= bits_ - 1; }
    std::size_t i() const noexcept { return static_cast<std::size_t>(std::countr_zero(bits_)) % tree_width; }
    std::size_t j() const noexcept { return static_cast<std::size_t>(std::countr_zero(bits_)) / tree_width; }
    bool is_in(std::uint64_t bits) const noexcept { return (bits_ & (0 - bits_) & bits) != 0; }

  private:
    static constexpr std::uint64_t all_of_one = 0xff, lane_of_each = 0x0101010101010101;

    std::uint64_t bits_;
};

// Names one pair of lanes.
struct LanesOfOne {
    std::size_t i, j;
};

// Returns the least of the bounds of the given pairs of lanes. There must be at least one pair.
inline float least_of(const LaneBounds& bounds, LanesOfOne lanes) noexcept {
    return bounds[tree_width * lanes.i + lanes.j];
}
inline float least_of(const LaneBounds& bounds, LanePairs lanes) noexcept {
    float least = std::numeric_limits<float>::infinity();
    for (; lanes.more(); lanes.next()) least = std::min(least, bounds[tree_width * lanes.i() + lanes.j()]);
    return least;
}

// Calls use(x, y) and returns its result; x and y are the BvhNode or TreeLeaf in each tree to which the pair refers.
template <class Use>
ECODS_ALWAYS_INLINE decltype(auto) with_nodes(const MeshBvh& a, const MeshBvh& b, const NodePair& pair, Use&& use) {
    if (pair.a.is_leaf()) {
        const TreeLeaf& x = a.leaves[pair.a.index()];
        return pair.b.is_leaf() ? use(x, b.leaves[pair.b.index()]) : use(x, b.nodes[pair.b.index()]);
    }
    const BvhNode& x = a.nodes[pair.a.index()];
    return pair.b.is_leaf() ? use(x, b.leaves[pair.b.index()]) : use(x, b.nodes[pair.b.index()]);
}

template <class X, class Y>
inline constexpr bool are_leaves = std::is_same_v<X, TreeLeaf>&& std::is_same_v<Y, TreeLeaf>;
template <class X, class Y>
inline constexpr bool are_nodes = std::is_same_v<X, BvhNode>&& std::is_same_v<Y, BvhNode>;

// Calls push(children, child_lanes) for each pair of children of x and y with a pair of lanes in `lanes`, in order. If
// x and y are both nodes, child_lanes is that one pair, a LanesOfOne. If one of the two is a leaf, the leaf is paired
// with each child of the node, and child_lanes are the LanePairs of that child. Not both may be leaves.
template <class X, class Y, class Push>
ECODS_ALWAYS_INLINE void push_children(const NodePair& pair, const X& x, const Y& y, LanePairs lanes, Push&& push) {
    static_assert(!are_leaves<X, Y>);
    if constexpr (are_nodes<X, Y>) {
        for (; lanes.more(); lanes.next()) {
            const LanesOfOne one{lanes.i(), lanes.j()};
            push(NodePair{x.child[one.i], y.child[one.j]}, one);
        }
    } else if constexpr (std::is_same_v<X, BvhNode>) {
        for (std::size_t i = 0; i < x.count; ++i) {
            if (const LanePairs of_child = lanes.of_first(i); of_child.more())
                push(NodePair{x.child[i], pair.b}, of_child);
        }
    } else {
        for (std::size_t j = 0; j < y.count; ++j) {
            if (const LanePairs of_child = lanes.of_second(j); of_child.more())
                push(NodePair{pair.a, y.child[j]}, of_child);
        }
    }
}

// Opens a pair. If both are leaves, returns leaves(x, y), which returns true if the walk should go on. Otherwise calls
// bound(x, y), which returns the lanes that may matter, as bits of LanePairs, and push(children, child_lanes) for their
// pairs of children (see push_children()), and returns true.
template <class Bound, class Push, class Leaves>
ECODS_ALWAYS_INLINE bool open_pair(const MeshBvh& a, const MeshBvh& b, const NodePair& pair, Bound&& bound, Push&& push,
                                   Leaves&& leaves) {
    return with_nodes(a, b, pair, [&](const auto& x, const auto& y) -> bool {
        using X = std::remove_cvref_t<decltype(x)>;
        using Y = std::remove_cvref_t<decltype(y)>;
        if constexpr (are_leaves<X, Y>) {
            return leaves(x, y);
        } else {
            push_children(pair, x, y, LanePairs(bound(x, y)), push);
            return true;
        }
    });
}

}  // namespace ecods
