// Builds the vertices, edges and faces of a convex set from the triangles of its border.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/sign/vertex_signs.hpp"
#include "query/convex/hull.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/proper_mesh.hpp"
#include "query/solid/split_edges.hpp"

namespace ecods::convex {

// The triangles that bound a solid. Two edges are either one edge or share at most a point.
struct Border {
    const ProperMesh* proper;
    const MeshEdges* edges;
    // By triangle: true if its corners turn right, seen from outside. Empty if none do.
    std::span<const std::uint8_t> faces_in;

    // The mesh in which features are named, and by triangle of `proper` its origin in that mesh. `origins` is empty if
    // both are the same mesh.
    const ProperMesh* named;
    std::span<const TriangleOrigin> origins;

    exact::VertexSigns signs;  // signs of vertices of `proper`

    bool turns_right(std::uint32_t triangle) const noexcept { return !faces_in.empty() && faces_in[triangle] != 0; }
    // The side of a triangle of `named` that contains `side`. Its corner is TriangleOrigin::none if `side` is inside
    // the triangle.
    SideRef origin(const SideRef& side) const noexcept {
        if (origins.empty()) return side;
        const TriangleOrigin& of = origins[side.triangle];
        return {of.triangle, of.sides[side.corner]};
    }
};

// The corner opposite to a side of a triangle.
inline std::uint32_t opposite_corner(const Triangle& triangle, std::uint32_t side) noexcept {
    return triangle[(side + 2) % 3];
}

// The sign of a vertex's position relative to a triangle's plane: positive outside. Exact.
int side_of_plane(const Border& border, std::uint32_t triangle, std::uint32_t vertex) noexcept;

// Builds the hull. The solid must be convex. By edge, `is_flat` is true if its two triangles are in one plane. Cost: n
// log n.
Hull build_hull(const Border& border, std::span<const std::uint8_t> is_flat);

}  // namespace ecods::convex
