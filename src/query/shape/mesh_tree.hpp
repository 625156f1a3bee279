// Defines the data that queries need of a mesh, computed once for each MeshShape.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

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
    std::uint64_t id;  // unique in the process: caches identify the tree by it
};

// MeshShapeAccess gives the library access to the derived data of a MeshShape. Each function computes its result on
// first use.
struct MeshShapeAccess {
    static const LocalFrame& frame(const MeshShape& shape);
    static const MeshTree& tree(const MeshShape& shape);
    // Computes the boxes of the shape at some poses: *boxes[i] = shape.MeshShape::box(*poses[i]).
    static void find_boxes(const MeshShape& shape, std::span<const Pose* const> poses, std::span<Aabb* const> boxes);
    static const CoplanarGroups& groups(const MeshShape& shape);

    // Returns the shape of the mesh scaled by 2^e (other_units.hpp). `make` creates it on first use. All calls for one
    // shape must pass the same e.
    static const MeshShape& in_other_units(const MeshShape& shape,
                                           std::shared_ptr<const Mesh> (*make)(const Mesh& mesh, int e), int e);

    // Returns the digest of the text that identifies the mesh in certificates (query/certificate); `make` computes it
    // on first use.
    static const Sha256::Digest& digest(const MeshShape& shape, Sha256::Digest (*make)(const MeshShape&));

    // Returns a shape that is the surface of `shape`, and shares all data derived from its mesh.
    static std::shared_ptr<const MeshShape> surface(const MeshShape& shape);

    // Returns the pieces of the mesh (query/solid/pieces.hpp), which `find` finds on first use.
    static const std::vector<std::uint32_t>& pieces(const MeshShape& shape,
                                                    std::vector<std::uint32_t> (*find)(const MeshShape& shape));

    // Returns the convex solid that covers a mesh of one triangle (query/convex/convex_core.hpp), which `make` creates
    // on first use.
    static const ConvexSolid& convex(const MeshShape& shape,
                                     std::unique_ptr<const ConvexSolid> (*make)(const MeshShape& shape));

    // Makes the tree of `shape` by refitting the tree of `model`, which must have the same triangles. No other thread
    // may use `shape` yet.
    static void refit_tree(const MeshShape& shape, const MeshShape& model);
};

}  // namespace ecods
