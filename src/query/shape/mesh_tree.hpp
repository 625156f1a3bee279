// Defines the data of a mesh that queries need, made once.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "base/sha256.hpp"
#include "bounds/local_frame.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "ecods/shape.hpp"
#include "exact/point/mesh_extent.hpp"
#include "query/shape/coplanar_groups.hpp"

namespace ecods {

struct MeshTree {
    exact::MeshExtent extent;
    MeshBvh boxes;
    std::uint64_t id;  // unique in the process; identifies what is cached for the tree
};

// Gives the library access to the parts of a MeshShape. Each part is made on first use.
struct MeshShapeAccess {
    static const LocalFrame& frame(const MeshShape& shape);
    static const MeshTree& tree(const MeshShape& shape);
    // Computes the boxes of some poses: *boxes[i] = shape.MeshShape::box(*poses[i]).
    static void find_boxes(const MeshShape& shape, std::span<const Pose* const> poses, std::span<Aabb* const> boxes);
    static const CoplanarGroups& groups(const MeshShape& shape);

    // The shape of the same mesh, scaled by 2^e (other_units.hpp). A shape must always be passed the same e.
    static const MeshShape& in_other_units(const MeshShape& shape,
                                           std::shared_ptr<const Mesh> (*make)(const Mesh& mesh, int e), int e);

    // The digest of the text that identifies the mesh in certificates (query/certificate), made by `make` on first use.
    static const Sha256::Digest& digest(const MeshShape& shape, Sha256::Digest (*make)(const MeshShape&));

    // Makes the tree of a new shape, which no other thread knows yet, from the tree of `model`, which has the same
    // triangles.
    static void refit_tree(const MeshShape& shape, const MeshShape& model);
};

}  // namespace ecods
