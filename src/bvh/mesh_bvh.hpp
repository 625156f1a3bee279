// A tree of boxes over the triangles of a mesh, eight children a node.
//
// Boxes are along the axes of the tree's frame, so they are oriented boxes of the mesh: RAPID's OBB tree (Gottschalk,
// Lin and Manocha, OBBTree, SIGGRAPH 1996) with one orientation for all of its boxes, which is what lets two nodes be
// tested against each other eight by eight. Numbers are floats, rounded outwards: a box contains what it stands for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bounds/local_frame.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

inline constexpr std::size_t tree_width = 8;
using FloatLanes = std::array<float, tree_width>;

// A node or a leaf.
class TreeRef {
  public:
    TreeRef() = default;
    static TreeRef node(std::size_t index) { return TreeRef(static_cast<std::uint32_t>(index)); }
    static TreeRef leaf(std::size_t index) { return TreeRef(static_cast<std::uint32_t>(index) | leaf_bit); }

    bool is_leaf() const noexcept { return bits_ & leaf_bit; }
    std::uint32_t index() const noexcept { return bits_ & ~leaf_bit; }

  private:
    static constexpr std::uint32_t leaf_bit = std::uint32_t{1} << 31;
    explicit TreeRef(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
};

// Neighbours in a smooth surface lie in a thin slab along their mean normal, which boxes know nothing of: for all of
// their points y, low <= normal . y <= high, exactly. The normal has a length of about one, or is zero.
struct Slab {
    std::array<float, 3> normal;
    float low;
    float high;
};

// Eight boxes, what is in them, and the slab of it all. Lanes from `count` on repeat the last one.
struct alignas(32) BvhNode {
    std::array<FloatLanes, 3> center;
    std::array<FloatLanes, 3> half;  // box: |y - center| <= half on each axis
    std::array<TreeRef, tree_width> child;
    Slab slab;
    std::uint32_t count;

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// Eight triangles. Coordinates are off by no more than corner_error. Lanes from `count` on repeat the last one.
struct alignas(32) TreeLeaf {
    std::array<std::array<FloatLanes, 3>, 3> corner;  // by corner and axis
    std::array<std::uint32_t, tree_width> triangle;   // in the mesh
    Slab slab;
    std::uint32_t count;

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// A coordinate of size at most one as a float, rounded in any mode, after the error of its computation.
inline constexpr double corner_error = 0x1p-23 + coordinate_error;

struct MeshBvh {
    LocalFrame frame;
    TreeRef root;
    std::array<float, 3> root_center{};
    std::array<float, 3> root_half{};
    std::vector<BvhNode> nodes;    // parents before children
    std::vector<TreeLeaf> leaves;  // from left to right
    double built_cost = 0;         // tree_cost when it was built

    std::size_t bytes() const noexcept {
        return sizeof(*this) + nodes.capacity() * sizeof(BvhNode) + leaves.capacity() * sizeof(TreeLeaf);
    }
};

// A binary tree by the surface area heuristic (Goldsmith and Salmon 1987) over bins (Wald 2007), with the count of
// leaves of eight in place of the count of triangles; made eight wide so that the surfaces of the nodes that stay are
// least in sum (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs through compressed wide BVHs, HPG
// 2017, section 3). Cost: n log n; no recursion.
MeshBvh build_mesh_bvh(const Mesh& mesh, const LocalFrame& frame);

// The tree of other vertices: the same triangles in the same nodes, new boxes. Built anew if its cost is more than
// half above what it was when it was built. `mesh` must have the triangles of the tree's mesh. Cost: one pass.
MeshBvh refit_mesh_bvh(const MeshBvh& tree, const Mesh& mesh);

// The sum of the surfaces of all boxes over that of the root's, in frame coordinates: what a random query visits.
double tree_cost(const MeshBvh& tree) noexcept;

}  // namespace ecods
