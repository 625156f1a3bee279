// Extends the bound of walks that search for common points by groups of coplanar triangles.
#pragma once

#include <cstdint>
#include <span>

#include "query/intersection/overlap_bound.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods {

// A PlaneBound makes a walk skip the pairs that OverlapBound skips. Once groups are in use, the walk also skips a pair
// of nodes if all triangles of each node lie in one plane, and the two planes are parallel with a gap, however small.
class PlaneBound {
  public:
    // The arguments must outlive this object. `relations` need not be bound to the bodies yet.
    PlaneBound(const OverlapBound& boxes, const MeshBvh& a, const MeshBvh& b, TriangleRelations& relations)
        : boxes_(boxes), a_(a), b_(b), relations_(relations) {}

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) {
        return are_apart(x, y) ? 0 : boxes_(x, y);
    }
    TrianglePairs operator()(const TreeLeaf& x, const TreeLeaf& y) {
        return are_apart(x, y) ? TrianglePairs{} : boxes_.triangle_pairs(x, y);
    }

    void order(const BvhNode& x, const BvhNode& y, LanePairs pairs, std::span<NodePair> children) const {
        boxes_.order(x, y, pairs, children);
    }

  private:
    // Returns true if all triangles of x are known to lie in one plane, all triangles of y in another, and these two
    // planes are parallel with a gap.
    template <class X, class Y>
    bool are_apart(const X& x, const Y& y) {
        if (!relations_.uses_groups()) return false;
        const std::uint32_t group_a = group_of(relations_.groups(0), a_, x);
        const std::uint32_t group_b = group_of(relations_.groups(1), b_, y);
        return group_a != CoplanarGroups::none && group_b != CoplanarGroups::none &&
               relations_.are_apart(group_a, group_b);
    }

    static std::uint32_t group_of(const CoplanarGroups& groups, const MeshBvh& tree, const BvhNode& node) noexcept {
        return groups.empty() ? CoplanarGroups::none
                              : groups.of_node[static_cast<std::size_t>(&node - tree.nodes.data())];
    }
    static std::uint32_t group_of(const CoplanarGroups& groups, const MeshBvh& tree, const TreeLeaf& leaf) noexcept {
        return groups.empty() ? CoplanarGroups::none
                              : groups.of_leaf[static_cast<std::size_t>(&leaf - tree.leaves.data())];
    }

    OverlapBound boxes_;
    const MeshBvh& a_;
    const MeshBvh& b_;
    TriangleRelations& relations_;
};

}  // namespace ecods
