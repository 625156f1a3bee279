// MeshBvh is the bounding volume hierarchy of a mesh: a tree of boxes over its triangles, with eight children per node.
//
// Boxes are aligned with the local frame of the mesh, so they are oriented boxes of the body. A MeshBvh is the OBB tree
// of RAPID (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996) with one orientation for all boxes of a tree. The
// common orientation makes it possible to test two nodes against each other eight by eight. Boxes are floats, rounded
// outwards, so that a box contains its triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bounds/local_frame.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

inline constexpr std::size_t tree_width = 8;
using FloatLanes = std::array<float, tree_width>;
// LaneBounds has a number for each pair of lanes of two nodes: a squared distance, a rank or a time. The pair of lanes
// i and j has index 8 i + j.
using LaneBounds = std::array<float, tree_width * tree_width>;

// A TreeRef is the index of a node or of a leaf, with a bit that says if it is a leaf.
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

// A Slab bounds some triangles along their mean normal: low <= normal . y <= high holds exactly for all of their points
// y. On a smooth surface it is much thinner than their box. The length of the normal is about one, or zero.
struct Slab {
    std::array<float, 3> normal;
    float low;
    float high;
};

// A BvhNode has up to eight children with their boxes, and the slab of all of their triangles. Lanes from `count` on
// repeat the last child.
struct alignas(32) BvhNode {
    std::array<FloatLanes, 3> center;
    std::array<FloatLanes, 3> half;  // box: |y - center| <= half on each axis
    std::array<TreeRef, tree_width> child;
    Slab slab;
    std::uint32_t count;
    bool is_thin;  // true if the slab is much thinner than the boxes along its normal

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// A TreeLeaf has up to eight triangles. Coordinates are off by at most corner_error. Lanes from `count` on repeat the
// last triangle.
//
// The vertices are copies from Mesh::triangles(), 12 bytes for each triangle, so that code that needs the exact corners
// does not have to load that list first. A leaf has the size of seven cache lines.
struct alignas(64) TreeLeaf {
    std::array<std::array<FloatLanes, 3>, 3> corner;  // [corner][axis][lane]
    std::array<std::uint32_t, tree_width> triangle;   // indices in the mesh
    Slab slab;
    std::uint32_t count;
    std::array<Triangle, tree_width> vertices;

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// corner_error is an upper bound of the error of a leaf's corner, on each axis: the error of computing a coordinate of
// magnitude at most one, and of rounding it to a float in any mode.
inline constexpr double corner_error = 0x1p-23 + coordinate_error;

struct MeshBvh {
    LocalFrame frame;
    TreeRef root;
    std::array<float, 3> root_center{};
    std::array<float, 3> root_half{};
    std::vector<BvhNode> nodes;    // parents come before their children
    std::vector<TreeLeaf> leaves;  // from left to right
    double built_cost = 0;         // tree_cost() just after the tree was built

    std::size_t bytes() const noexcept {
        return sizeof(*this) + nodes.capacity() * sizeof(BvhNode) + leaves.capacity() * sizeof(TreeLeaf);
    }
};

// Builds a binary tree by the surface area heuristic (Goldsmith and Salmon 1987) with bins (Wald 2007), where costs
// count leaves of eight triangles. Then merges it to a tree with eight children per node such that the sum of the
// surfaces of the remaining nodes is least (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs
// through compressed wide BVHs, HPG 2017, section 3). Cost: n log n; no recursion.
MeshBvh build_mesh_bvh(const Mesh& mesh, const LocalFrame& frame);

// Returns a tree for `mesh`, which must have the triangles of the tree's mesh and may have other vertices. Each
// triangle stays in its leaf, and boxes are computed again. If this raises tree_cost() to more than 1.5 times the cost
// just after building, a new tree is built. Cost: one pass over the triangles, or the cost of build_mesh_bvh().
MeshBvh refit_mesh_bvh(const MeshBvh& tree, const Mesh& mesh);

// Returns the sum of the surfaces of all boxes divided by the root's surface, in frame coordinates: the expected number
// of boxes that a random query visits.
double tree_cost(const MeshBvh& tree) noexcept;

}  // namespace ecods
