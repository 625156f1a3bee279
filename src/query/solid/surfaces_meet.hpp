// Whether posed triangles share a point, where some triangles of their meshes do not count.
#pragma once

#include "ecods/intersection.hpp"
#include "ecods/posed.hpp"
#include "ecods/solid.hpp"
#include "exact/point/frame.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/proper_mesh.hpp"

namespace ecods {

struct SurfaceAt {
    exact::BodyRef body;
    const MeshTree& tree;      // of body.mesh
    const ProperMesh* proper;  // which triangles count; null: all of them

    explicit SurfaceAt(const Posed<MeshShape>& posed);  // all triangles
    explicit SurfaceAt(const Posed<Solid>& posed);      // those that bound the solid

    bool has(std::uint32_t triangle) const noexcept { return proper == nullptr || proper->is_proper(triangle); }
};

// Whether the trees' boxes are certainly apart; if not, the axes of `state` are bound to them.
bool are_boxes_apart(const SurfaceAt& a, const SurfaceAt& b, QueryMemoryAccess::State& state);

// Binds a frame to both, where they were modelled if they have one pose.
exact::Frame& bind(exact::Frame& frame, const SurfaceAt& a, const SurfaceAt& b);

// Under any poses, which must outlive the call.
bool surfaces_meet(const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory);

}  // namespace ecods
