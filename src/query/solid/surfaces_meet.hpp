// surfaces_meet() decides whether two posed meshes share a point. Some triangles of each mesh may be left out.
#pragma once

#include "ecods/intersection.hpp"
#include "ecods/pose.hpp"
#include "ecods/solid.hpp"
#include "exact/point/frame.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

struct SurfaceAt {
    exact::BodyRef body;
    const MeshTree& tree;      // tree of body.mesh
    const ProperMesh* proper;  // says which triangles count; null if all do

    explicit SurfaceAt(const Posed<MeshShape>& posed);  // all triangles count
    explicit SurfaceAt(const Posed<Solid>& posed);      // only triangles with an area count

    bool has(std::uint32_t triangle) const noexcept { return proper == nullptr || proper->is_proper(triangle); }
};

// Returns true if the boxes of the two trees are certainly apart. If not, the axes of `state` are bound to both trees.
bool are_boxes_apart(const SurfaceAt& a, const SurfaceAt& b, QueryMemoryAccess::State& state);

// Binds a frame to both bodies. If both have the same pose, the frame uses the coordinates of the meshes, without the
// pose.
exact::Frame& bind(exact::Frame& frame, const SurfaceAt& a, const SurfaceAt& b);

// Returns true if a triangle of a and a triangle of b that both count share a point, under any poses. The poses must
// outlive the call.
bool surfaces_meet(const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory);

}  // namespace ecods
