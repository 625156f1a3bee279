#include "query/convex/hull_features.hpp"

namespace ecods::convex {

Feature name_of(const Hull& hull, const HullFeature& feature) noexcept {
    switch (feature.kind) {
        case Feature::Kind::vertex:
            return hull.vertex_names[feature.index];
        case Feature::Kind::edge:
            return hull.edges[feature.index].name;
        default:
            return hull.faces[feature.index].name;
    }
}

std::uint32_t edge_of(const Hull& hull, std::uint32_t from, std::uint32_t to) noexcept {
    for (const Hull::Neighbor& n : hull.neighbors_of(from)) {
        if (n.vertex == to) return n.edge;
    }
    ECODS_ASSERT(false);
    return 0;
}

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
    return ~std::uint32_t{0};
}

HullFeature LevelEdges::feature(const Hull& hull, std::uint32_t vertex) const noexcept {
    if (count == 0) return {Feature::Kind::vertex, vertex};
    if (count == 1) return {Feature::Kind::edge, edges[0]};
    const auto& faces = hull.edges[edges[0]].faces;
    return {Feature::Kind::face, is_edge_of(hull, edges[1], faces[0]) ? faces[0] : faces[1]};
}

}  // namespace ecods::convex
