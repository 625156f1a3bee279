// Walks of one tree that visit the nearest nodes first keep the nodes to be visited on a stack.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "simd/inline.hpp"

namespace ecods {

// Holds a node or leaf to be visited, and a lower bound of its number: the parameter r at which a line meets it, or its
// squared distance from a point.
struct OrderedNode {
    float from;
    TreeRef ref;
};

// Prefetches a node or leaf that will be visited soon.
ECODS_ALWAYS_INLINE void prefetch(const MeshBvh& tree, TreeRef ref) noexcept {
    constexpr std::size_t line = 64;
    const char* const first = ref.is_leaf() ? reinterpret_cast<const char*>(&tree.leaves[ref.index()])
                                            : reinterpret_cast<const char*>(&tree.nodes[ref.index()]);
    const std::size_t size = ref.is_leaf() ? sizeof(TreeLeaf) : sizeof(BvhNode);
    for (std::size_t i = 0; i < size; i += line) __builtin_prefetch(first + i);
}

// Pushes the children in `lanes` on the stack that ends at `top`, sorted such that the nearest is on top. Returns the
// new top.
ECODS_ALWAYS_INLINE OrderedNode* push_nearest_last(const MeshBvh& tree, const BvhNode& node, std::uint32_t lanes,
                                                   const FloatLanes& from, OrderedNode* top) noexcept {
    OrderedNode* const first = top;
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const OrderedNode next{from[lane], node.child[lane]};
        prefetch(tree, next.ref);
        OrderedNode* at = top++;
        for (; at > first && at[-1].from < next.from; --at) *at = at[-1];
        *at = next;
    }
    return top;
}

}  // namespace ecods
