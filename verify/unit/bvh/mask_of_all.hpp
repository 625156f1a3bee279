// Masks of pairs of nodes, once they are the same for every instruction set.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <span>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "environment/instruction_sets.hpp"

namespace ecods {

// Returns ask(numbers), which fills in what bounds the pairs of the mask. Fails where another set gives another mask,
// or other numbers for the pairs in it.
template <class Ask>
std::uint64_t mask_of_all(LaneBounds& numbers, Ask&& ask) {
    alignas(32) LaneBounds others;
    const std::uint64_t mask = ask(numbers);
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limited(set);
        EXPECT_EQ(ask(others), mask) << environment::name(set);
        for (LanePairs lanes(mask); lanes.more(); lanes.next()) {
            const std::size_t at = tree_width * lanes.i() + lanes.j();
            EXPECT_EQ(std::memcmp(&others[at], &numbers[at], sizeof(float)), 0) << environment::name(set);
        }
    }
    return mask;
}

// The bound of walk_two that is a mask: mask(x, y) of two nodes or leaves.
template <class Mask>
struct MaskBound {
    Mask mask;

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) {
        return mask(x, y);
    }
    void order(const BvhNode&, const BvhNode&, LanePairs, std::span<NodePair>) {}
};
template <class Mask>
MaskBound(Mask) -> MaskBound<Mask>;

}  // namespace ecods
