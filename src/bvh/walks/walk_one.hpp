// walk_one walks one tree depth-first from its root.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/assert.hpp"
#include "simd/inline.hpp"

namespace ecods {

// FixedStack is a stack of at most `capacity` items, stored in the object itself.
template <class T, std::size_t capacity>
class FixedStack {
  public:
    ECODS_ALWAYS_INLINE bool empty() const noexcept { return size_ == 0; }
    ECODS_ALWAYS_INLINE std::size_t size() const noexcept { return size_; }
    ECODS_ALWAYS_INLINE const T& back() const noexcept { return items_[size_ - 1]; }
    ECODS_ALWAYS_INLINE void clear() noexcept { size_ = 0; }
    ECODS_ALWAYS_INLINE void pop_back() noexcept { --size_; }
    ECODS_ALWAYS_INLINE void push_back(const T& item) noexcept {
        ECODS_ASSERT(size_ < capacity);
        items_[size_++] = item;
    }

  private:
    std::array<T, capacity> items_;
    std::size_t size_ = 0;
};

// Says which child of a node is visited first: the last one or the first one.
enum class LaneOrder : std::uint8_t { last_first, first_first };

// Visits the nodes of a tree depth-first.
//
// `tree` provides Tree::Node, root(), is_bottom(node) and child(node, lane). `stack` is scratch: a vector, or a
// FixedStack with space for all nodes that can wait at once. bound(node) is called once for each visited node, and
// returns a mask of the lanes that may matter. result(node, lanes) is called with these lanes for each bottom node, and
// returns true if the walk should go on. Both are inlined, so a walk is compiled for the instruction set of its caller.
template <LaneOrder order = LaneOrder::last_first, class Tree, class Stack, class Bound, class Result>
ECODS_ALWAYS_INLINE void walk_one(const Tree& tree, Stack& stack, Bound&& bound, Result&& result) {
    stack.clear();
    stack.push_back(tree.root());
    while (!stack.empty()) {
        const typename Tree::Node node = stack.back();
        stack.pop_back();
        std::uint32_t lanes = bound(node);
        if (tree.is_bottom(node)) {
            if (!result(node, lanes)) return;
            continue;
        }
        while (lanes != 0) {
            const int lane = order == LaneOrder::last_first ? std::countr_zero(lanes) : std::bit_width(lanes) - 1;
            lanes ^= std::uint32_t{1} << lane;
            stack.push_back(tree.child(node, static_cast<std::uint32_t>(lane)));
        }
    }
}

}  // namespace ecods
