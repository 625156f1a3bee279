// What a Solid holds beside its mesh and its tree.
#pragma once

#include <memory>
#include <vector>

#include "base/lazy.hpp"
#include "ecods/solid.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"
#include "query/solid/shells.hpp"
#include "query/solid/split_edges.hpp"

namespace ecods {

struct Solid::Parts {
    // The triangles of the solid: those of its mesh by the same indices, unless edges were split.
    ProperMesh proper;
    MeshEdges edges;
    // By triangle of proper.mesh, the one that it is a part of, where edges were split; otherwise empty.
    std::vector<TriangleOrigin> origins;
    // The shape of proper.mesh where edges were split; otherwise null, and the solid's own tree is its tree.
    std::unique_ptr<const MeshShape> split_shape;
    // What prove_star() has found out, before the shells are made of it; empty if it has proven nothing.
    std::vector<std::uint8_t> star_faces_in;
    Lazy<Shells> shells;
};

// The library's own way to the parts of a Solid.
struct SolidAccess {
    using Parts = Solid::Parts;

    static const Parts& parts(const Solid& solid) noexcept { return *solid.solid_parts_; }
    static const MeshTree& tree(const Solid& solid);  // of parts().proper.mesh
    static const Shells& shells(const Solid& solid);  // made when asked for first
};

void require_valid(const Vec3& point);  // throws InvalidArgument

}  // namespace ecods
