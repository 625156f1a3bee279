// Builds the vertices, edges and faces of a convex set from the triangles of its border.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/sign/vertex_signs.hpp"
#include "query/convex/hull.hpp"
#include "query/solid/flat_mesh.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"
#include "query/solid/split_edges.hpp"

namespace ecods::convex {

// A Border holds the triangles that bound a solid. Any two of their sides are the same edge or share at most a point.
struct Border {
    const ProperMesh* proper;
    const MeshEdges* edges;
    // Has an entry for each triangle: true if its corners turn right, seen from outside. The list is empty if no
    // triangle's corners turn right.
    std::span<const std::uint8_t> faces_in;

    // `named` is the mesh in which features are named. By triangle of `proper`, `origins` holds the triangle of `named`
    // that contains it as a piece. `origins` is empty if both are the same mesh.
    const ProperMesh* named;
    std::span<const TriangleOrigin> origins;

    exact::VertexSigns signs;  // exact signs of the vertices of `proper`

    bool turns_right(std::uint32_t triangle) const noexcept { return !faces_in.empty() && faces_in[triangle] != 0; }
    // Returns the side of a triangle of `named` that contains `side`. If `side` is inside that triangle, the corner of
    // the result is TriangleOrigin::none.
    SideRef origin(const SideRef& side) const noexcept {
        if (origins.empty()) return side;
        const TriangleOrigin& of = origins[side.triangle];
        return {of.triangle, of.sides[side.corner]};
    }
};

// Returns the corner opposite to a side of the triangle.
inline std::uint32_t opposite_corner(const Triangle& triangle, std::uint32_t side) noexcept {
    return triangle[(side + 2) % 3];
}

// Returns the sign of the vertex's position relative to the triangle's plane: positive outside the solid. Exact.
int side_of_plane(const Border& border, std::uint32_t triangle, std::uint32_t vertex) noexcept;

// Builds the hull of a solid, which must be convex. `is_flat` says, by edge, whether the edge's two triangles are in
// one plane. Cost: n log n.
Hull build_hull(const Border& border, std::span<const std::uint8_t> is_flat);

// Builds the hull of a mesh that covers a flat convex set. Cost: n log n.
Hull build_flat_hull(const ProperMesh& proper, const FlatMesh& flat);

// Sets hull.neighbors to the neighbors of each vertex, from the hull's edges. All other members must be set.
void add_neighbors(Hull& hull);

}  // namespace ecods::convex
