// Walks the corners of a posed mesh's triangles that may have at most a given height above a half space.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <vector>

#include "bvh/walks/tree_view.hpp"
#include "query/half_space/heights.hpp"
#include "query/half_space/lowest.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods::half_spaces {

struct Memory final : QueryMemoryPart {
    // A Candidate is a corner whose height, or time, may be the least one, and a lower bound of this height or time.
    struct Candidate {
        Corner corner;
        double low;
    };

    std::vector<TreeRef> stack;
    std::vector<Candidate> candidates;

    static Memory& of(QueryMemory& memory) {
        return QueryMemoryAccess::part<Memory>(memory, &QueryMemoryAccess::State::half_space);
    }
};

// Keeps only the first candidate by name for each vertex, and sorts the list of candidates by vertex.
inline void keep_one_a_vertex(std::vector<Memory::Candidate>& candidates) {
    const auto vertex_of = [](const Memory::Candidate& c) { return c.corner.vertex; };
    std::ranges::sort(candidates, {}, [](const Memory::Candidate& c) {
        return std::tuple(c.corner.vertex, c.corner.triangle, c.corner.index);
    });
    const auto later = std::ranges::unique(candidates, {}, vertex_of);
    candidates.erase(later.begin(), later.end());
}

// Calls take(corner) for the corners in the parts of the tree that may have points with heights of at most limit().
// Ends when take() returns true. limit() may decrease meanwhile.
template <class Limit, class Take>
void walk_below(const BoxHeights& boxes, QueryMemory& memory, const Limit& limit, const Take& take) {
    const MeshBvh& tree = boxes.tree();
    std::uint64_t& box_tests = QueryMemoryAccess::state(memory).counts.box_tests;
    ++box_tests;
    if (boxes.low(tree.root_center, tree.root_half) > limit()) return;
    const TreeView view(tree);
    const auto bound = [&](TreeRef ref) {
        ++box_tests;
        return view.with(ref, [&](const auto& at) { return boxes.lanes_below(at, limit()); });
    };
    const auto result = [&](TreeRef ref, std::uint32_t lanes) {
        const TreeLeaf& leaf = view.leaf(ref);
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            for (std::uint32_t index = 0; index < 3; ++index) {
                if (take(Corner{leaf.triangle[lane], index, leaf.vertices[lane][index]})) return false;
            }
        }
        return true;
    };
    walk_one(view, Memory::of(memory).stack, bound, result);
}

}  // namespace ecods::half_spaces
