#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "bvh/tree/frame_box.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/tree/slabs.hpp"
#include "bvh/tree/sweep_split.hpp"

namespace ecods {
namespace {

using PrimitiveRefs = std::vector<PrimitiveRef>;

// A Range names triangles by their places in the builder's list, and has their box.
struct Range {
    std::uint32_t begin;
    std::uint32_t end;
    FrameBox box;

    std::uint32_t size() const noexcept { return end - begin; }
};

// Splits ranges in two parts by the surface area heuristic.
class Splitter {
  public:
    explicit Splitter(PrimitiveRefs& items) : items_(items) {}

    // Returns the two halves of `part`, neither of which is empty. The caller must split depth-first: after a split
    // come all splits of one half, and then all splits of the other half. Therefore the parts of a block are split one
    // after the other, and one block at a time is kept.
    std::array<Range, 2> split(const Range& part) {
        if (part.size() > SweepSplit::size_max) {
            const std::uint32_t middle = split_by_bins(part);
            return {box_of(part.begin, middle), box_of(middle, part.end)};
        }
        if (part.begin < block_begin_ || part.end > block_end_) {
            block_begin_ = part.begin;
            block_end_ = part.end;
            block_.begin(std::span(items_).subspan(part.begin, part.size()));
        }
        const std::uint32_t begin = part.begin - block_begin_, end = part.end - block_begin_;
        const std::uint32_t middle = block_.split(begin, end);
        return {Range{part.begin, block_begin_ + middle, block_.box_of(begin, middle)},
                Range{block_begin_ + middle, part.end, block_.box_of(middle, end)}};
    }

    Range box_of(std::uint32_t begin, std::uint32_t end) const {
        Range part{begin, end, {}};
        for (std::uint32_t i = begin; i < end; ++i) part.box.include(items_[i].box);
        return part;
    }

  private:
    static constexpr std::size_t bin_count = 16;

    struct Bin {
        FrameBox box;
        std::uint32_t count = 0;
    };

    // Splits the range at the cheapest border between bins of equal width, and returns the first place of the second
    // half. If all middles of boxes are equal, or boxes are infinite, it returns the middle of the range.
    std::uint32_t split_by_bins(const Range& part) {
        FrameBox middles;
        for (std::uint32_t i = part.begin; i < part.end; ++i) {
            const Float4 middle = items_[i].middle();
            middles.include({middle, middle});
        }
        const Float4 size = middles.max - middles.min;
        const Float4 factor = static_cast<float>(bin_count) * 0.999f / size;  // so that no item is beyond the last bin

        std::array<std::array<Bin, bin_count>, 3> bins{};
        const auto bin_of = [&](const PrimitiveRef& item, int axis) {
            const float x = (item.middle()[axis] - middles.min[axis]) * factor[axis];
            return std::min(static_cast<std::size_t>(x), bin_count - 1);
        };
        std::array<bool, 3> is_wide;
        for (int axis = 0; axis < 3; ++axis) {
            is_wide[static_cast<std::size_t>(axis)] = factor[axis] > 0 && factor[axis] < FrameBox::infinity;
        }
        for (std::uint32_t i = part.begin; i < part.end; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!is_wide[static_cast<std::size_t>(axis)]) continue;
                Bin& bin = bins[static_cast<std::size_t>(axis)][bin_of(items_[i], axis)];
                bin.box.include(items_[i].box);
                ++bin.count;
            }
        }
        float best = FrameBox::infinity;
        int best_axis = -1;
        std::size_t best_bin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!is_wide[static_cast<std::size_t>(axis)]) continue;
            const auto& row = bins[static_cast<std::size_t>(axis)];
            std::array<float, bin_count> left_cost;
            Bin sum;
            const auto add = [&](const Bin& bin) {
                sum.box.include(bin.box);
                sum.count += bin.count;
                return sum.count == 0 ? 0 : sum.box.surface() * leaf_visits(sum.count);
            };
            for (std::size_t b = 0; b + 1 < bin_count; ++b) left_cost[b + 1] = add(row[b]);
            sum = {};
            for (std::size_t b = bin_count - 1; b > 0; --b) {
                const float cost = add(row[b]) + left_cost[b];
                if (sum.count != 0 && sum.count != part.size() && cost < best) {
                    best = cost;
                    best_axis = axis;
                    best_bin = b;
                }
            }
        }
        if (best_axis < 0) return part.begin + part.size() / 2;
        const auto middle =
            std::partition(items_.begin() + part.begin, items_.begin() + part.end,
                           [&](const PrimitiveRef& item) { return bin_of(item, best_axis) < best_bin; });
        return static_cast<std::uint32_t>(middle - items_.begin());
    }

    PrimitiveRefs& items_;
    SweepSplit block_;
    std::uint32_t block_begin_ = 0, block_end_ = 0;
};

// Holds the numbers of roots into which the left and the right half of a node are divided.
struct Split {
    std::uint8_t left = 0;  // both are 0 if the node itself is a root
    std::uint8_t right = 0;
};

// BinaryNode is a node of the binary tree, from which the tree with eight children per node is made.
struct BinaryNode {
    FrameBox box;
    std::uint32_t begin;                     // first item of a leaf
    std::uint32_t count;                     // items of a leaf; 0 for an inner node
    std::uint32_t child;                     // first child of an inner node; the second one follows it
    Split children;                          // split of an inner node that becomes a node with eight children
    std::array<float, tree_width> cost;      // [k - 1]: cost of the node as at most k roots
    std::array<Split, tree_width> split_at;  // [k - 1]: the split with that cost
};

class Builder {
  public:
    Builder(const Mesh& mesh, const LocalFrame& frame) : mesh_(mesh) {
        tree_.frame = frame;
        items_.resize(mesh.triangles().size());
        for (std::uint32_t i = 0; i < items_.size(); ++i) {
            items_[i] = PrimitiveRef(box_of(mesh, mesh.triangles()[i], tree_.frame), i);
        }
    }

    MeshBvh build() {
        build_binary();
        find_costs();
        widen();
        set_root(tree_, binary_[0].box);
        tree_.built_cost = tree_cost(tree_);
        return std::move(tree_);
    }

  private:
    void build_binary() {
        Splitter splitter(items_);
        binary_.reserve(items_.size() / 3 + 1);
        binary_.emplace_back();
        std::vector<std::pair<Range, std::uint32_t>> open{
            {splitter.box_of(0, static_cast<std::uint32_t>(items_.size())), 0}};
        while (!open.empty()) {
            const auto [part, index] = open.back();
            open.pop_back();
            BinaryNode& node = binary_[index];
            node.box = part.box;
            node.begin = part.begin;
            node.count = part.size() <= tree_width ? part.size() : 0;
            if (node.count != 0) continue;
            node.child = static_cast<std::uint32_t>(binary_.size());
            for (const Range& half : splitter.split(part)) {
                open.emplace_back(half, static_cast<std::uint32_t>(binary_.size()));
                binary_.emplace_back();
            }
        }
    }

    // Computes, from the leaves up, the least cost of each binary node if it is divided into at most k roots, for k
    // from 1 to 8. Each root is a leaf or a node with eight children, and is visited with a probability proportional to
    // its surface.
    void find_costs() {
        for (std::size_t i = binary_.size(); i-- > 0;) {
            BinaryNode& node = binary_[i];
            node.split_at = {};
            if (node.count != 0) {
                node.cost.fill(node.box.surface());
                continue;
            }
            for (std::size_t k = 2; k <= tree_width; ++k) find_splits(node, k);
            node.children = node.split_at[tree_width - 1];
            node.cost[0] = node.box.surface() + node.cost[tree_width - 1];
            for (std::size_t k = 1; k < tree_width; ++k) {
                if (node.cost[k - 1] > node.cost[k]) continue;
                node.cost[k] = node.cost[k - 1];  // fewer roots are cheaper
                node.split_at[k] = node.split_at[k - 1];
            }
        }
    }

    // Sets the cost and the split of a node for `count` roots: the cheapest distribution of `count` roots to its two
    // halves.
    void find_splits(BinaryNode& node, std::size_t count) {
        const BinaryNode& left = binary_[node.child];
        const BinaryNode& right = binary_[node.child + 1];
        for (std::size_t l = 1; l < count; ++l) {
            const float cost = left.cost[l - 1] + right.cost[count - l - 1];
            if (l > 1 && !(cost < node.cost[count - 1])) continue;
            node.cost[count - 1] = cost;
            node.split_at[count - 1] = {static_cast<std::uint8_t>(l), static_cast<std::uint8_t>(count - l)};
        }
    }

    struct Pending {
        std::uint32_t binary;
        std::uint32_t parent;
        std::size_t lane;
    };
    static constexpr std::uint32_t no_parent = ~0u;

    void widen() {
        tree_.leaves.reserve(binary_.size() / 2 + 1);
        std::vector<Pending> open{{0, no_parent, 0}};
        while (!open.empty()) {
            const Pending next = open.back();
            open.pop_back();
            const BinaryNode& top = binary_[next.binary];
            const TreeRef ref = top.count != 0 ? TreeRef::leaf(tree_.leaves.size()) : TreeRef::node(tree_.nodes.size());
            (next.parent == no_parent ? tree_.root : tree_.nodes[next.parent].child[next.lane]) = ref;
            if (top.count != 0) {
                add_leaf(top);
                continue;
            }
            std::array<std::uint32_t, tree_width> roots;
            const std::size_t count = find_roots(top, roots);
            BvhNode& node = tree_.nodes.emplace_back();
            node.count = static_cast<std::uint32_t>(count);
            for (std::size_t lane = 0; lane < tree_width; ++lane) {
                set_lane(node, lane, binary_[roots[std::min(lane, count - 1)]].box);
            }
            for (std::size_t lane = count; lane-- > 0;) open.push_back({roots[lane], ref.index(), lane});
        }
        tree_.nodes.shrink_to_fit();
        tree_.leaves.shrink_to_fit();
        set_corners_and_slabs(tree_, mesh_);
    }

    // Sets `roots` to the binary nodes that become the children of `top`, from left to right, and returns their number.
    std::size_t find_roots(const BinaryNode& top, std::array<std::uint32_t, tree_width>& roots) const {
        struct Subtree {
            std::uint32_t node;
            std::size_t count;
        };
        std::array<Subtree, tree_width> parts;  // at most eight, because each becomes at least one root
        std::size_t part_count = 0, root_count = 0;
        const auto divide = [&](const BinaryNode& node, Split split_at) {
            parts[part_count++] = {node.child + 1, split_at.right};
            parts[part_count++] = {node.child, split_at.left};
        };
        divide(top, top.children);
        while (part_count > 0) {
            const Subtree part = parts[--part_count];
            const BinaryNode& node = binary_[part.node];
            const Split split_at = node.split_at[part.count - 1];
            if (split_at.left == 0)
                roots[root_count++] = part.node;
            else
                divide(node, split_at);
        }
        return root_count;
    }

    void add_leaf(const BinaryNode& part) {
        TreeLeaf& leaf = tree_.leaves.emplace_back();
        leaf.count = part.count;
        for (std::uint32_t lane = 0; lane < tree_width; ++lane) {
            leaf.triangle[lane] = items_[part.begin + std::min(lane, part.count - 1)].triangle();
        }
    }

    const Mesh& mesh_;
    MeshBvh tree_;
    PrimitiveRefs items_;
    std::vector<BinaryNode> binary_;
};

}  // namespace

MeshBvh build_mesh_bvh(const Mesh& mesh, const LocalFrame& frame) {
    return Builder(mesh, frame).build();
}

}  // namespace ecods
