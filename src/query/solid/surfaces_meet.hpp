// Decides if two posed meshes share a point, leaving out some of their triangles.
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
    const ProperMesh* proper;  // the triangles that count; null if all do

    explicit SurfaceAt(const Posed<MeshShape>& posed);  // all triangles count
    explicit SurfaceAt(const Posed<Solid>& posed);      // those that bound the solid count

    bool has(std::uint32_t triangle) const noexcept { return proper == nullptr || proper->is_proper(triangle); }
};

// True if the trees' boxes are certainly apart. If false, the axes of `state` are bound to both trees.
bool are_boxes_apart(const SurfaceAt& a, const SurfaceAt& b, QueryMemoryAccess::State& state);

// Binds a frame to both bodies. If both have one pose, the frame uses the models' own coordinates.
exact::Frame& bind(exact::Frame& frame, const SurfaceAt& a, const SurfaceAt& b);

// True if the counted triangles share a point, under any poses. The poses must outlive the call.
bool surfaces_meet(const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory);

}  // namespace ecods
