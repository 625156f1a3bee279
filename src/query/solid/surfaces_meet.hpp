// Whether posed triangles share a point, where some triangles of their meshes do not count.
#pragma once

#include "ecods/intersection.hpp"
#include "ecods/posed.hpp"
#include "ecods/solid.hpp"
#include "exact/point/frame.hpp"
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

// Under any poses, which must outlive the call.
bool surfaces_meet(const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory);

}  // namespace ecods
