// Defines the data that a Solid holds in addition to its mesh and its tree.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/lazy.hpp"
#include "ecods/solid.hpp"
#include "query/shape/mesh_tree.hpp"
#include "query/solid/flat_mesh.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"
#include "query/solid/shells.hpp"
#include "query/solid/split_edges.hpp"

namespace ecods {

// SolidBoundary holds the triangles of positive area of a solid's mesh.
struct SolidBoundary {
    std::unique_ptr<const MeshShape> shape;  // null if all triangles have area
    std::vector<std::uint32_t> names;        // by triangle of `shape`: the triangle of the solid's mesh
};

struct Solid::Parts {
    // Has the triangles that bound the solid, with the indices of the solid's mesh unless edges were split.
    ProperMesh proper;
    MeshEdges edges;
    // Names, for each triangle of proper.mesh, the triangle of the solid's mesh of which it is a piece. The list is
    // empty if no edges were split.
    std::vector<TriangleOrigin> origins;
    // Holds the shape of proper.mesh if edges were split; otherwise null, because the solid's own tree is the tree of
    // proper.mesh.
    std::unique_ptr<const MeshShape> split_shape;
    // Holds the result of prove_star(), from which the shells are made; empty if prove_star() proved nothing.
    std::vector<std::uint8_t> star_faces_in;
    Lazy<Shells> shells;
    // Has an entry for each triangle of the solid's mesh: true if the triangle is a part of the boundary, because its
    // area is positive. The list is empty if all triangles are parts of the boundary.
    std::vector<std::uint8_t> has_area;
    // Holds the flat set if the solid is flat, and so has no interior; otherwise null. If `flat` is set, only `proper`
    // and `has_area` of the members above are set. All triangles of a segment or a point are parts of its boundary.
    std::unique_ptr<const FlatMesh> flat;
    Lazy<std::shared_ptr<const MeshShape>> surface;
    Lazy<SolidBoundary> boundary;
};

// SolidAccess gives the library access to the parts of a Solid.
struct SolidAccess {
    using Parts = Solid::Parts;

    static const Parts& parts(const Solid& solid) noexcept { return *solid.solid_parts_; }
    static const MeshTree& tree(const Solid& solid);                             // tree of parts().proper.mesh
    static const Shells& shells(const Solid& solid);                             // made on first use
    static const std::shared_ptr<const MeshShape>& surface(const Solid& solid);  // made on first use
    static const SolidBoundary& boundary(const Solid& solid);                    // made on first use
};

// Returns true if the shape has inner points: it is a solid, but not a flat one.
inline bool has_inside(const MeshShape& shape) noexcept {
    return shape.form() != MeshForm::surface && SolidAccess::parts(static_cast<const Solid&>(shape)).flat == nullptr;
}

void require_valid(const Vec3& point);  // throws InvalidArgument

}  // namespace ecods
