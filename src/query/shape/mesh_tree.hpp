// The data that queries need of a mesh, made once.
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
    std::uint64_t id;  // of no other tree of the process: what is kept of a tree is known by it
};

// The library's own way to the parts of a MeshShape. Each part is made when it is asked for first.
struct MeshShapeAccess {
    static const LocalFrame& frame(const MeshShape& shape);
    static const MeshTree& tree(const MeshShape& shape);
    // shape.MeshShape::box() of some poses.
    static void find_boxes(const MeshShape& shape, std::span<const Pose* const> poses, std::span<Aabb* const> boxes);
    static const CoplanarGroups& groups(const MeshShape& shape);

    // The shape of the same mesh 2^e times as large (other_units.hpp); e is the same whenever this is asked of a shape.
    static const MeshShape& in_other_units(const MeshShape& shape,
                                           std::shared_ptr<const Mesh> (*make)(const Mesh& mesh, int e), int e);

    // The digest of the text by which certificates mean the mesh (query/certificate): what `make` makes when it is
    // asked first.
    static const Sha256::Digest& digest(const MeshShape& shape, Sha256::Digest (*make)(const MeshShape&));

    // Makes the tree of a shape that nobody has seen yet from that of `model`, which has the same triangles.
    static void refit_tree(const MeshShape& shape, const MeshShape& model);
};

}  // namespace ecods
