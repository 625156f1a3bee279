// The walk of two trees of triangles at once, nearest pairs of nodes first.
#pragma once

#include <concepts>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/nearest_queue.hpp"
#include "bvh/walks/open_pair.hpp"

namespace ecods {

// A search says what it wants of a walk, nearest first.
//
// `limit()` is the bound beyond which no pair matters: such pairs are not taken from the queue. `find_near(x, y,
// bounds)` is asked once for each pair visited that is not two leaves, x and y being a BvhNode or a TreeLeaf of the
// first and the second tree; it sets bounds, which are finite, for pairs of lanes, which it returns as bits, as
// near_mask does. `visits(pair)` is asked of each pair taken from the queue, and may lower the limit: if it is false,
// the walk ends. `take(x, y)` takes two leaves, and returns whether the walk goes on.
template <class Search>
concept NearestSearch = requires(Search& search, const BvhNode& node, const TreeLeaf& leaf, LaneBounds& bounds,
                                 const NearPair& pair) {
    { search.limit() } -> std::same_as<float>;
    { search.find_near(node, node, bounds) } -> std::same_as<std::uint64_t>;
    { search.find_near(node, leaf, bounds) } -> std::same_as<std::uint64_t>;
    { search.find_near(leaf, node, bounds) } -> std::same_as<std::uint64_t>;
    { search.visits(pair) } -> std::same_as<bool>;
    { search.take(leaf, leaf) } -> std::same_as<bool>;
};

// Visits pairs of nodes in the order of their bounds, or nearly so, until no pair that is left can matter. `queue` is
// working memory.
template <NearestSearch Search>
void walk_nearest(const MeshBvh& a, const MeshBvh& b, NearestQueue& queue, Search& search) {
    alignas(32) LaneBounds bounds;
    queue.start(search.limit());
    queue.push({0, {a.root, b.root}});
    const auto bound = [&](const auto& x, const auto& y) { return search.find_near(x, y, bounds); };
    const auto push = [&](const NodePair& children, const auto& lanes) {
        queue.push({least_of(bounds, lanes), children});
    };
    const auto take = [&](const TreeLeaf& x, const TreeLeaf& y) { return search.take(x, y); };
    NearPair top;
    while (queue.pop(search.limit(), top)) {
        if (!search.visits(top)) return;
        if (top.square <= search.limit() && !open_pair(a, b, top.nodes, bound, push, take)) return;
    }
}

}  // namespace ecods
