// A Polygon is a vertex, an edge or a face of a hull, as a convex polygon that is seen along a normal.
#pragma once

#include <cstdint>

#include "base/short_list.hpp"
#include "query/convex/hull_features.hpp"

namespace ecods::patches {

using convex::HullFeature;

struct Polygon {
    // `is_turned` must be true if the hull's cycles of its faces are clockwise around the normal.
    Polygon(const convex::Hull& hull, const HullFeature& of, bool is_turned);

    std::size_t vertex_count() const noexcept { return corners.size(); }
    std::size_t edge_count() const noexcept { return corners.size() < 3 ? corners.size() - 1 : corners.size(); }
    std::size_t next(std::size_t i) const noexcept { return i + 1 == corners.size() ? 0 : i + 1; }
    std::size_t previous(std::size_t i) const noexcept { return i == 0 ? corners.size() - 1 : i - 1; }
    bool is_face() const noexcept { return feature.kind == Feature::Kind::face; }

    HullFeature vertex(std::size_t i) const noexcept { return {Feature::Kind::vertex, corners[i].vertex}; }
    HullFeature edge(std::size_t i) const noexcept { return {Feature::Kind::edge, corners[i].edge}; }
    // Returns the index of the polygon's vertex or edge `part`. Searches the polygon from vertex `start` on.
    std::size_t index_of(const HullFeature& part, std::size_t start = 0) const noexcept;

    HullFeature feature;
    // `corners` holds the vertices, each with the edge to the next one. The vertices of a face are counterclockwise
    // around the normal.
    ShortList<convex::Hull::Neighbor, 32> corners;
};

}  // namespace ecods::patches
