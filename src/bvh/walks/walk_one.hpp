// The walk of one tree from its root to what a question wants of it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/assert.hpp"
#include "simd/inline.hpp"

namespace ecods {

// Visits nodes depth first, children that were found last first.
//
// `tree` names its nodes: Tree::Node, root(), is_bottom(node), child(node, lane), and Tree::stack_size, the largest
// number of nodes that can wait at once. `bound(node)` returns the lanes of the node that may matter, as bits; it is
// asked once a node. `result(node, lanes)` takes those of a bottom node, and returns whether the walk goes on. Both are
// inlined, so a walk is compiled for the instruction set of its caller.
template <class Tree, class Bound, class Result>
ECODS_ALWAYS_INLINE void walk_one(const Tree& tree, Bound&& bound, Result&& result) {
    std::array<typename Tree::Node, Tree::stack_size> stack;
    std::size_t depth = 0;
    stack[depth++] = tree.root();
    while (depth > 0) {
        const typename Tree::Node node = stack[--depth];
        std::uint32_t lanes = bound(node);
        if (tree.is_bottom(node)) {
            if (!result(node, lanes)) return;
            continue;
        }
        for (; lanes != 0; lanes &= lanes - 1) {
            ECODS_ASSERT(depth < Tree::stack_size);
            stack[depth++] = tree.child(node, static_cast<std::uint32_t>(std::countr_zero(lanes)));
        }
    }
}

}  // namespace ecods
