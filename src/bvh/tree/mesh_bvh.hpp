// The bounding volume hierarchy of a mesh: a tree of boxes over its triangles, eight children per node.
//
// Boxes are aligned with the local frame of the mesh, so they are oriented boxes of the body: RAPID's OBB tree
// (Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996) with one orientation for all boxes of a tree. Because of that,
// two nodes are tested against each other eight by eight. Numbers are floats, rounded outwards: a box contains its
// triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bounds/local_frame.hpp"
#include "ecods/mesh.hpp"

namespace ecods {

inline constexpr std::size_t tree_width = 8;
using FloatLanes = std::array<float, tree_width>;
// A number for each pair of lanes of two nodes: a squared distance, a rank or a time. Lanes i and j have it at 8 i + j.
using LaneBounds = std::array<float, tree_width * tree_width>;

// The index of a node or of a leaf, and which of the two it is.
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

// A slab along the mean normal of some triangles: low <= normal . y <= high for all of their points y, exactly. On a
// smooth surface it is much thinner than their box. The normal has a length of about one, or is zero.
struct Slab {
    std::array<float, 3> normal;
    float low;
    float high;
};

// Eight children with their boxes, and the slab of all of their triangles. Lanes from `count` on repeat the last one.
struct alignas(32) BvhNode {
    std::array<FloatLanes, 3> center;
    std::array<FloatLanes, 3> half;  // box: |y - center| <= half on each axis
    std::array<TreeRef, tree_width> child;
    Slab slab;
    std::uint32_t count;
    bool is_thin;  // the slab is much thinner than the boxes along its normal

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// Eight triangles. Coordinates are off by at most corner_error. Lanes from `count` on repeat the last one.
//
// The vertices are copies from Mesh::triangles(), 12 bytes a triangle, so that a reader of the exact corners does not
// first wait for that list. A leaf is seven cache lines.
struct alignas(64) TreeLeaf {
    std::array<std::array<FloatLanes, 3>, 3> corner;  // by corner and axis
    std::array<std::uint32_t, tree_width> triangle;   // index in the mesh
    Slab slab;
    std::uint32_t count;
    std::array<Triangle, tree_width> vertices;

    std::uint32_t lanes() const noexcept { return (1u << count) - 1; }
};

// Bounds the error of a leaf's corner, on each axis: the error of computing a coordinate of size at most one, and of
// rounding it to a float in any mode.
inline constexpr double corner_error = 0x1p-23 + coordinate_error;

struct MeshBvh {
    LocalFrame frame;
    TreeRef root;
    std::array<float, 3> root_center{};
    std::array<float, 3> root_half{};
    std::vector<BvhNode> nodes;    // parents before children
    std::vector<TreeLeaf> leaves;  // from left to right
    double built_cost = 0;         // tree_cost just after build_mesh_bvh

    std::size_t bytes() const noexcept {
        return sizeof(*this) + nodes.capacity() * sizeof(BvhNode) + leaves.capacity() * sizeof(TreeLeaf);
    }
};

// Builds a binary tree by the surface area heuristic (Goldsmith and Salmon 1987) over bins (Wald 2007), counting leaves
// of eight in place of triangles. Collapses it to eight children per node such that the sum of the surfaces of the
// remaining nodes is least (Ylitie, Karras and Laine, Efficient incoherent ray traversal on GPUs through compressed
// wide BVHs, HPG 2017, section 3). Cost: n log n; no recursion.
MeshBvh build_mesh_bvh(const Mesh& mesh, const LocalFrame& frame);

// Returns the tree of `mesh`, which must have the triangles of the tree's mesh and may have other vertices: each
// triangle stays in its leaf, and boxes are computed again. If that raises tree_cost to more than 1.5 times the cost
// just after building, builds a new tree instead. Cost: one pass, or that of build_mesh_bvh.
MeshBvh refit_mesh_bvh(const MeshBvh& tree, const Mesh& mesh);

// Returns the sum of the surfaces of all boxes, divided by the root's, in frame coordinates: the expected number of
// boxes that a random query visits.
double tree_cost(const MeshBvh& tree) noexcept;

}  // namespace ecods
