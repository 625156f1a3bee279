// Trees made by hand, of every small shape, and which of the triangles of two of them matter. A walk sees children and
// lanes alone, so these trees have no boxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/walks/open_pair.hpp"

namespace ecods {

// A node with its children, or a leaf.
struct TreeShape {
    std::vector<TreeShape> children;
};

// All sequences of trees with so many nodes and leaves together.
inline std::vector<std::vector<TreeShape>> forests_of(std::size_t count) {
    if (count == 0) return {{}};
    std::vector<std::vector<TreeShape>> result;
    for (std::size_t first = 1; first <= count; ++first) {
        for (const std::vector<TreeShape>& below : forests_of(first - 1)) {
            for (std::vector<TreeShape> forest : forests_of(count - first)) {
                forest.insert(forest.begin(), TreeShape{below});
                result.push_back(std::move(forest));
            }
        }
    }
    return result;
}

// A set of triangles, as bits: trees here have at most 64.
using TriangleBits = std::uint64_t;

class SmallTree {
  public:
    // Leaf k has triangle_counts[k % size] triangles. Triangles are numbered against the order of the leaves.
    SmallTree(const TreeShape& shape, const std::vector<std::uint32_t>& triangle_counts) : counts_(triangle_counts) {
        tree.root = add(shape);
        for (TreeLeaf& leaf : tree.leaves) {
            for (std::size_t lane = 0; lane < leaf.count; ++lane) leaf.triangle[lane] = --left_;
            for (std::size_t lane = leaf.count; lane < tree_width; ++lane)
                leaf.triangle[lane] = leaf.triangle[leaf.count - 1];
        }
    }

    std::uint32_t triangle_count() const noexcept { return triangle_count_; }

    TreeRef name_of(const BvhNode& x) const { return TreeRef::node(static_cast<std::size_t>(&x - tree.nodes.data())); }
    TreeRef name_of(const TreeLeaf& x) const {
        return TreeRef::leaf(static_cast<std::size_t>(&x - tree.leaves.data()));
    }

    // The triangles of each lane.
    std::vector<TriangleBits> lanes_of(TreeRef ref) const {
        std::vector<TriangleBits> result;
        if (ref.is_leaf()) {
            const TreeLeaf& leaf = tree.leaves[ref.index()];
            for (std::size_t i = 0; i < leaf.count; ++i) result.push_back(TriangleBits{1} << leaf.triangle[i]);
        } else {
            for (const TreeRef child : children_of(ref)) result.push_back(below(child));
        }
        return result;
    }
    std::vector<TreeRef> children_of(TreeRef node) const {
        const BvhNode& x = tree.nodes[node.index()];
        return {x.child.begin(), x.child.begin() + x.count};
    }
    TriangleBits below(TreeRef ref) const {
        TriangleBits bits = 0;
        for (const TriangleBits lane : lanes_of(ref)) bits |= lane;
        return bits;
    }

    MeshBvh tree;

  private:
    TreeRef add(const TreeShape& shape) {
        if (shape.children.empty()) {
            TreeLeaf leaf{};
            leaf.count = counts_[tree.leaves.size() % counts_.size()];
            triangle_count_ = left_ += leaf.count;
            tree.leaves.push_back(leaf);
            return TreeRef::leaf(tree.leaves.size() - 1);
        }
        const std::size_t at = tree.nodes.size();
        tree.nodes.emplace_back();
        BvhNode node{};
        for (const TreeShape& child : shape.children) node.child[node.count++] = add(child);
        for (std::size_t lane = node.count; lane < tree_width; ++lane) node.child[lane] = node.child[node.count - 1];
        tree.nodes[at] = node;
        return TreeRef::node(at);
    }

    std::vector<std::uint32_t> counts_;
    std::uint32_t left_ = 0, triangle_count_ = 0;
};

// The trees of 1 to `count_max` nodes and leaves, with leaves of one to three triangles, of eight, and a node of eight
// leaves: chains of nodes with a single child are among them.
inline std::vector<SmallTree> small_trees(std::size_t count_max) {
    std::vector<SmallTree> result;
    for (std::size_t count = 0; count < count_max; ++count) {
        for (const std::vector<TreeShape>& below : forests_of(count)) {
            result.emplace_back(TreeShape{below}, std::vector<std::uint32_t>{2, 1, 3});
        }
    }
    result.emplace_back(TreeShape{}, std::vector<std::uint32_t>{8});
    result.emplace_back(TreeShape{std::vector<TreeShape>(8)}, std::vector<std::uint32_t>{8, 1, 8, 5});
    return result;
}

// Which pairs of triangles of two trees matter.
class PairsThatMatter {
  public:
    template <class Matters>
    PairsThatMatter(const SmallTree& a, const SmallTree& b, const Matters& matters) : partners_(a.triangle_count()) {
        for (std::uint32_t i = 0; i < a.triangle_count(); ++i) {
            for (std::uint32_t j = 0; j < b.triangle_count(); ++j) {
                if (matters(i, j)) partners_[i] |= TriangleBits{1} << j;
            }
        }
    }

    bool has(std::uint32_t i, std::uint32_t j) const { return (partners_[i] >> j & 1) != 0; }
    // Whether a pair of two sets of triangles is among them.
    bool has_any(TriangleBits x, TriangleBits y) const {
        for (std::size_t i = 0; i < partners_.size(); ++i) {
            if ((x >> i & 1) != 0 && (partners_[i] & y) != 0) return true;
        }
        return false;
    }
    // The pairs of lanes of two nodes or leaves that have one, as a walk asks for them.
    std::uint64_t lanes_of(const SmallTree& a, TreeRef x, const SmallTree& b, TreeRef y) const {
        const std::vector<TriangleBits> of_x = a.lanes_of(x), of_y = b.lanes_of(y);
        std::uint64_t lanes = 0;
        for (std::size_t j = 0; j < of_y.size(); ++j) {
            for (std::size_t i = 0; i < of_x.size(); ++i) {
                if (has_any(of_x[i], of_y[j])) lanes |= std::uint64_t{1} << (tree_width * j + i);
            }
        }
        return lanes;
    }

  private:
    std::vector<TriangleBits> partners_;
};

// A node or leaf, and a pair of them, as numbers that compare.
inline std::uint64_t number_of(TreeRef ref) noexcept {
    return std::uint64_t{2} * ref.index() + ref.is_leaf();
}
using PairNumber = std::pair<std::uint64_t, std::uint64_t>;
inline PairNumber number_of(const NodePair& pair) noexcept {
    return {number_of(pair.a), number_of(pair.b)};
}

}  // namespace ecods
