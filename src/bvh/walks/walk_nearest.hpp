// The walk of two trees of triangles at once, nearest pairs of nodes first.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/nearest_queue.hpp"
#include "bvh/walks/walk_two.hpp"

namespace ecods {

// Visits pairs of nodes in the order of their bounds, or nearly so, until no pair that is left can matter.
//
// `bound(x, y, squares)` is asked once for each pair visited that is not two leaves, x and y being a BvhNode or a
// TreeLeaf of the first and the second tree; it sets bounds for pairs of lanes, which it returns as bits, as near_mask
// does. `result.limit()` is the bound beyond which no pair matters: such pairs are not queued. `result.visits(pair)` is
// asked of each pair taken from the queue, a NearPair: if it is false, the walk ends. `result(x, y)` takes two leaves,
// and returns whether the walk goes on. `queue` is working memory. Bounds are finite.
template <class Bound, class Result>
void walk_nearest(const MeshBvh& a, const MeshBvh& b, NearestQueue& queue, Bound&& bound, Result&& result) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    alignas(32) LaneSquares squares;
    std::array<float, tree_width> least;
    queue.start(result.limit());
    queue.push({0, a.root, b.root});
    NearPair top;
    while (queue.pop(result.limit(), top)) {
        if (!result.visits(top)) return;
        if (top.a.is_leaf() && top.b.is_leaf()) {
            if (!result(a.leaves[top.a.index()], b.leaves[top.b.index()])) return;
        } else if (top.a.is_leaf()) {
            const BvhNode& y = b.nodes[top.b.index()];
            least.fill(infinity);
            for (LanePairs pairs(bound(a.leaves[top.a.index()], y, squares)); pairs.more(); pairs.next()) {
                least[pairs.j()] = std::min(least[pairs.j()], squares[tree_width * pairs.i() + pairs.j()]);
            }
            for (std::size_t j = 0; j < y.count; ++j) {
                if (least[j] < infinity) queue.push({least[j], top.a, y.child[j]});
            }
        } else if (top.b.is_leaf()) {
            const BvhNode& x = a.nodes[top.a.index()];
            least.fill(infinity);
            for (LanePairs pairs(bound(x, b.leaves[top.b.index()], squares)); pairs.more(); pairs.next()) {
                least[pairs.i()] = std::min(least[pairs.i()], squares[tree_width * pairs.i() + pairs.j()]);
            }
            for (std::size_t i = 0; i < x.count; ++i) {
                if (least[i] < infinity) queue.push({least[i], x.child[i], top.b});
            }
        } else {
            const BvhNode& x = a.nodes[top.a.index()];
            const BvhNode& y = b.nodes[top.b.index()];
            for (LanePairs pairs(bound(x, y, squares)); pairs.more(); pairs.next()) {
                const std::size_t i = pairs.i(), j = pairs.j();
                queue.push({squares[tree_width * i + j], x.child[i], y.child[j]});
            }
        }
    }
}

}  // namespace ecods
