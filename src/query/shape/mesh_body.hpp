// References a posed mesh for a query.
#pragma once

#include <optional>

#include "ecods/ids.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// References a mesh, its pose and its tree, so that a query copies nothing.
struct MeshBody {
    MeshBody(const MeshShape& of, const Pose& at) : shape(of), pose(at), tree(MeshShapeAccess::tree(of)) {}
    explicit MeshBody(const Posed<MeshShape>& posed) : MeshBody(*posed.what, posed.pose) {}

    const Mesh& mesh() const noexcept { return shape.mesh(); }
    exact::BodyRef ref() const noexcept { return {&shape.mesh(), &tree.extent, &pose}; }

    const MeshShape& shape;
    const Pose& pose;
    const MeshTree& tree;
};

// The two bodies of a query.
struct MeshPair {
    // The pair of triangles that a witness names, if both bodies have these triangles.
    std::optional<TrianglePair> named_by(const PairWitness& w) const noexcept {
        if (w.a >= a.mesh().triangles().size() || w.b >= b.mesh().triangles().size()) return std::nullopt;
        return TrianglePair{w.a, w.b};
    }

    MeshBody a, b;
};

}  // namespace ecods
