// Defines MeshBody and MeshPair, by which a query refers to posed meshes.
#pragma once

#include <optional>

#include "base/assert.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "geometry/find_invalid.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// A MeshBody refers to a mesh, its pose and its tree, and copies none of them.
struct MeshBody {
    MeshBody(const MeshShape& of, const Pose& at) : shape(of), pose(at), tree(MeshShapeAccess::tree(of)) {
        ECODS_ASSERT(is_finite(at));
    }
    explicit MeshBody(const Posed<MeshShape>& posed) : MeshBody(*posed.what, posed.pose) {}

    const Mesh& mesh() const noexcept { return shape.mesh(); }
    exact::BodyRef ref() const noexcept { return {&shape.mesh(), &tree.extent, &pose}; }

    const MeshShape& shape;
    const Pose& pose;
    const MeshTree& tree;
};

// Returns a mesh whose only vertex is the origin. Posed by a translation, it represents a point as a body.
inline const MeshShape& point_shape() {
    static const MeshShape shape(Mesh::create({Vec3(0, 0, 0)}, {Triangle{0, 0, 0}}));
    return shape;
}

// A MeshPair holds the two bodies of a query.
struct MeshPair {
    // Returns the pair of triangles that the witness names; nullopt unless both bodies have these triangles.
    std::optional<TrianglePair> named_by(const PairWitness& w) const noexcept {
        if (w.a >= a.mesh().triangles().size() || w.b >= b.mesh().triangles().size()) return std::nullopt;
        return TrianglePair{w.a, w.b};
    }

    MeshBody a, b;
};

}  // namespace ecods
