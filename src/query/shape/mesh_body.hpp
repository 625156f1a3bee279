// A posed mesh as the questions about it see it.
#pragma once

#include <optional>

#include "ecods/ids.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"
#include "exact/point/frame.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// A mesh, its pose and its tree, by reference: for the length of a query nothing is copied.
struct MeshBody {
    MeshBody(const MeshShape& of, const Pose& at) : shape(of), pose(at), tree(MeshShapeAccess::tree(of)) {}
    explicit MeshBody(const Posed<MeshShape>& posed) : MeshBody(*posed.what, posed.pose) {}

    const Mesh& mesh() const noexcept { return shape.mesh(); }
    exact::BodyRef ref() const noexcept { return {&shape.mesh(), &tree.extent, &pose}; }

    const MeshShape& shape;
    const Pose& pose;
    const MeshTree& tree;
};

// A point is a body: this mesh of one vertex at the origin, under a pose that moves it there.
inline const MeshShape& point_shape() {
    static const MeshShape shape(Mesh::create({Vec3(0, 0, 0)}, {Triangle{0, 0, 0}}));
    return shape;
}

// The two bodies of a question.
struct MeshPair {
    // The pair of triangles that a witness has, if both bodies have these.
    std::optional<TrianglePair> named_by(const PairWitness& w) const noexcept {
        if (w.a >= a.mesh().triangles().size() || w.b >= b.mesh().triangles().size()) return std::nullopt;
        return TrianglePair{w.a, w.b};
    }

    MeshBody a, b;
};

}  // namespace ecods
