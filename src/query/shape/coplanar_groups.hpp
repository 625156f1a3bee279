// Which triangles of a mesh lie in one plane, exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/tree/mesh_bvh.hpp"
#include "exact/point/mesh_extent.hpp"

namespace ecods {

// Groups of two or more triangles of one plane that are turned the same way. An affine map keeps them in one plane, so
// the side of that plane on which a point lies needs to be decided once for all of them, under any pose.
//
// A group need not be all triangles of its plane. Triangles of no area are in none.
struct CoplanarGroups {
    static constexpr std::uint32_t none = 0xffffffff;

    std::vector<std::uint32_t> of_triangle;  // the group, or none
    std::vector<std::uint32_t> first;        // by group: its least triangle
    std::vector<std::int8_t> side;           // by group: 1 or -1 if the mesh is nowhere on the other side; 0: not known
    std::vector<std::uint32_t> of_node;      // the group of all triangles below a node, or none
    std::vector<std::uint32_t> of_leaf;      // ... of a leaf

    bool empty() const noexcept { return first.empty(); }
};

// Cost: n log n. Sides are known of few groups where the mesh has many, so that finding them costs some passes.
CoplanarGroups find_coplanar_groups(const Mesh& mesh, const exact::MeshExtent& extent, const MeshBvh& tree);

}  // namespace ecods
