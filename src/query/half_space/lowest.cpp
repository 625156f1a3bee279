#include "query/half_space/lowest.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "query/half_space/corners_below.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods::half_spaces {
namespace {

using Candidate = Memory::Candidate;

// Returns an upper bound of the least height: descends into the lowest box of each node, and bounds the height of the
// lowest corner of the leaf at the end.
double dive(const MeshShape& shape, const Heights& heights, const BoxHeights& boxes) {
    const MeshBvh& tree = boxes.tree();
    TreeRef at = tree.root;
    while (!at.is_leaf()) {
        const BvhNode& node = tree.nodes[at.index()];
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < node.count; ++i) {
            const double low = boxes.low({node.center[0][i], node.center[1][i], node.center[2][i]},
                                         {node.half[0][i], node.half[1][i], node.half[2][i]});
            if (!(low < least)) continue;
            least = low;
            best = i;
        }
        at = node.child[best];
    }
    const TreeLeaf& leaf = tree.leaves[at.index()];
    double high = std::numeric_limits<double>::infinity();
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        for (const std::uint32_t vertex : leaf.vertices[lane]) {
            high = std::min(high, heights.bounds(shape.mesh().vertices()[vertex]).high);
        }
    }
    return high;
}

// Returns the candidate with the least exact height; of equal heights, the first by name. Compares one corner for each
// vertex.
Corner decide(const MeshShape& shape, const Heights& heights, std::vector<Candidate>& candidates) {
    keep_one_a_vertex(candidates);
    const Corner* best = &candidates.front().corner;
    if (candidates.size() == 1) return *best;
    std::optional<exact::ScaledInteger> least;
    for (const auto& [corner, low] : candidates) {
        exact::ScaledInteger h = heights.exact(shape.mesh().vertices()[corner.vertex]);
        const int order = least ? compare(h, *least) : -1;
        if (order > 0 || (order == 0 && best->name() < corner.name())) continue;
        best = &corner;
        least = std::move(h);
    }
    return *best;
}

}  // namespace

Corner find_lowest(const MeshShape& shape, const Heights& heights, QueryMemory& memory) {
    std::vector<Candidate>& candidates = Memory::of(memory).candidates;
    candidates.clear();
    const BoxHeights boxes(heights, MeshShapeAccess::tree(shape).boxes);
    double limit = dive(shape, heights, boxes);
    walk_below(
        boxes, memory, [&] { return limit; },
        [&](const Corner& corner) {
            const HeightBounds h = heights.bounds(shape.mesh().vertices()[corner.vertex]);
            if (h.low > limit) return false;
            limit = std::min(limit, h.high);
            candidates.push_back({corner, h.low});
            return false;
        });
    std::erase_if(candidates, [&](const Candidate& c) { return c.low > limit; });
    return decide(shape, heights, candidates);
}

bool reaches_plane(const MeshShape& shape, const Heights& heights, QueryMemory& memory) {
    std::vector<Candidate>& unsure = Memory::of(memory).candidates;
    unsure.clear();
    bool reaches = false;
    walk_below(
        BoxHeights(heights, MeshShapeAccess::tree(shape).boxes), memory, [] { return 0.0; },
        [&](const Corner& corner) {
            const HeightBounds h = heights.bounds(shape.mesh().vertices()[corner.vertex]);
            reaches = h.high <= 0;
            if (!reaches && !(h.low > 0)) unsure.push_back({corner, h.low});
            return reaches;
        });
    if (reaches) return true;
    keep_one_a_vertex(unsure);
    return std::ranges::any_of(unsure, [&](const Candidate& c) {
        return heights.exact(shape.mesh().vertices()[c.corner.vertex]).sign() <= 0;
    });
}

}  // namespace ecods::half_spaces
