// walk_nearest walks two trees of triangles at once and visits the nearest pairs of nodes first.
#pragma once

#include <concepts>
#include <cstdint>

#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/nearest_queue.hpp"
#include "bvh/walks/open_pair.hpp"

namespace ecods {

// NearestSearch lists the functions that walk_nearest() calls.
//
// `limit()` returns the current limit: pairs whose bound exceeds it are not visited. `find_near(x, y, bounds)` is
// called once for each visited pair except two leaves; x and y are a BvhNode or a TreeLeaf of the first and the second
// tree. find_near() returns a mask of pairs of lanes and sets their bounds, which are finite, as near_mask() does.
// `visits(pair)` is called for each pair that is taken from the queue, and may lower the limit; if it returns false,
// the walk ends. `take(x, y)` is called for each visited pair of leaves, and returns true if the walk should go on.
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

// Visits pairs of nodes, nearly in the order of their bounds, until no remaining pair is within the limit. `queue` is
// scratch.
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
