// TreeView makes the tree of a mesh usable by walk_one.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/walk_one.hpp"

namespace ecods {

class TreeView {
  public:
    using Node = TreeRef;

    explicit TreeView(const MeshBvh& tree) : TreeView(tree, tree.root) {}
    // Makes a view of the subtree at `root`.
    TreeView(const MeshBvh& tree, TreeRef root) : tree_(tree), root_(root) {}

    TreeRef root() const noexcept { return root_; }
    bool is_bottom(TreeRef ref) const noexcept { return ref.is_leaf(); }
    TreeRef child(TreeRef ref, std::uint32_t lane) const noexcept { return tree_.nodes[ref.index()].child[lane]; }

    const TreeLeaf& leaf(TreeRef ref) const noexcept { return tree_.leaves[ref.index()]; }
    // Calls use(x) and returns its result; x is the BvhNode or the TreeLeaf to which `ref` refers.
    template <class Use>
    decltype(auto) with(TreeRef ref, Use&& use) const {
        return ref.is_leaf() ? use(leaf(ref)) : use(tree_.nodes[ref.index()]);
    }

  private:
    const MeshBvh& tree_;
    TreeRef root_;
};

// Visits the triangles of a tree that may matter. bound(x) is called with a BvhNode or a TreeLeaf, and returns a mask
// of the lanes that may matter. result(triangle) is called for each triangle in these lanes, and returns true if the
// walk should go on. `stack` is scratch.
template <class Bound, class Result>
void walk_triangles(const MeshBvh& tree, std::vector<TreeRef>& stack, Bound&& bound, Result&& result) {
    const TreeView view(tree);
    const auto all = [&](TreeRef ref, std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            if (!result(view.leaf(ref).triangle[static_cast<std::size_t>(std::countr_zero(lanes))])) return false;
        }
        return true;
    };
    walk_one(
        view, stack, [&](TreeRef ref) { return view.with(ref, bound); }, all);
}

}  // namespace ecods
