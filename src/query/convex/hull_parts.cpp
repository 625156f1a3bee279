// Vertices, edges and faces of a hull, found by their vertices, and their names.
#include "query/convex/closest_hulls.hpp"

namespace ecods::convex {
namespace {

std::uint32_t edge_of(const Hull& hull, std::uint32_t from, std::uint32_t to) noexcept {
    for (const Hull::Neighbor& n : hull.neighbors_of(from)) {
        if (n.vertex == to) return n.edge;
    }
    ECODS_ASSERT(false);  // Vertices that alone are furthest along a direction are the ends of an edge.
    return 0;
}

}  // namespace

std::uint32_t face_of(const Hull& hull, const std::array<std::uint32_t, 3>& vertices) noexcept {
    const auto has = [&](std::uint32_t vertex, std::uint32_t face) {
        for (const Hull::Neighbor& n : hull.neighbors_of(vertex)) {
            if (is_edge_of(hull, n.edge, face)) return true;
        }
        return false;
    };
    for (const Hull::Neighbor& n : hull.neighbors_of(vertices[0])) {
        for (const std::uint32_t face : hull.edges[n.edge].faces) {
            if (has(vertices[1], face) && has(vertices[2], face)) return face;
        }
    }
    return SupportPoints::none;
}

HullPart LevelEdges::part(const Hull& hull, std::uint32_t vertex) const noexcept {
    if (count == 0) return {Feature::Kind::vertex, vertex};
    if (count == 1) return {Feature::Kind::edge, edges[0]};
    const auto& faces = hull.edges[edges[0]].faces;
    return {Feature::Kind::face, is_edge_of(hull, edges[1], faces[0]) ? faces[0] : faces[1]};
}

HullPart ClosestHulls::part(const PosedHulls& hulls, std::size_t side) const noexcept {
    if (parts[side]) return *parts[side];
    const Hull& hull = hulls.hull(side);
    switch (found.corner_count(side)) {
        case 1:
            return {Feature::Kind::vertex, found.corner(side, 0)};
        case 2:
            return {Feature::Kind::edge, edge_of(hull, found.corner(side, 0), found.corner(side, 1))};
        default:
            return {Feature::Kind::face, face_of(hull, found.corners[side])};
    }
}

Feature part_name(const Hull& hull, const HullPart& part) noexcept {
    switch (part.kind) {
        case Feature::Kind::vertex:
            return hull.vertex_names[part.index];
        case Feature::Kind::edge:
            return hull.edges[part.index].name;
        default:
            return hull.faces[part.index].name;
    }
}

}  // namespace ecods::convex
