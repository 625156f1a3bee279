// The parts of a convex set from triangles that make up its border.
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

// Triangles that bound a solid, in which no edges lie along each other that are not one edge.
struct Border {
    const ProperMesh* proper;
    const MeshEdges* edges;
    // By triangle: whether its corners turn right, seen from outside. Empty if none do.
    std::span<const std::uint8_t> faces_in;

    // The mesh that features are named in, and by triangle of `proper` what of it that is. Where it is the same mesh,
    // `origins` is empty.
    const ProperMesh* named;
    std::span<const TriangleOrigin> origins;

    exact::VertexSigns signs;  // of the vertices of `proper`

    bool turns_right(std::uint32_t triangle) const noexcept { return !faces_in.empty() && faces_in[triangle] != 0; }
    // The side of a triangle of `named` of which a side is part; its corner is TriangleOrigin::none if it is inside
    // one.
    SideRef origin(const SideRef& side) const noexcept {
        if (origins.empty()) return side;
        const TriangleOrigin& of = origins[side.triangle];
        return {of.triangle, of.sides[side.corner]};
    }
};

// The corner that a side of a triangle leaves out.
inline std::uint32_t opposite_corner(const Triangle& triangle, std::uint32_t side) noexcept {
    return triangle[(side + 2) % 3];
}

// The sign of where a point is with respect to the plane of a triangle: positive outside. Exact.
int side_of_plane(const Border& border, std::uint32_t triangle, std::uint32_t vertex) noexcept;

// The solid must be convex; by edge, `is_flat` says whether its two triangles are in one plane. Cost: n log n.
Hull build_hull(const Border& border, std::span<const std::uint8_t> is_flat);

}  // namespace ecods::convex
