// Groups the triangles of a mesh that lie exactly in one plane.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/tree/mesh_bvh.hpp"
#include "exact/point/mesh_extent.hpp"

namespace ecods {

// CoplanarGroups are groups of two or more triangles that lie in one plane and face the same side. An affine map keeps
// a group in one plane. So under any pose, a point needs to be compared with this plane only once for the whole group.
//
// A group need not contain all triangles of its plane. Triangles without area are in no group.
struct CoplanarGroups {
    static constexpr std::uint32_t none = 0xffffffff;

    std::vector<std::uint32_t> of_triangle;  // by triangle: its group, or none
    std::vector<std::uint32_t> first;        // by group: its least triangle
    std::vector<std::int8_t> side;  // by group: the closed side of its plane that has the mesh, 1 or -1; 0 if unknown
    std::vector<std::uint32_t> of_node;  // by node: group of all triangles below it, or none
    std::vector<std::uint32_t> of_leaf;  // by leaf: group of all its triangles, or none

    bool empty() const noexcept { return first.empty(); }
};

// Returns the groups of coplanar triangles of the mesh. Cost: n log n. If the mesh has many groups, `side` is computed
// only for the first few, with one pass over the vertices for each.
CoplanarGroups find_coplanar_groups(const Mesh& mesh, const exact::MeshExtent& extent, const MeshBvh& tree);

}  // namespace ecods
