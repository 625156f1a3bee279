#include "query/patch/polygon.hpp"

#include "base/assert.hpp"

namespace ecods::patches {

Polygon::Polygon(const convex::Hull& hull, const HullFeature& of, bool is_turned) : feature(of) {
    if (of.kind == Feature::Kind::vertex) {
        corners.push_back({of.index, 0});
        return;
    }
    if (of.kind == Feature::Kind::edge) {
        for (const std::uint32_t end : hull.edges[of.index].ends) corners.push_back({end, of.index});
        return;
    }
    const auto cycle = hull.cycle_of(of.index);
    if (!is_turned) {
        for (const convex::Hull::Neighbor& corner : cycle) corners.push_back(corner);
        return;
    }
    // Reverses the cycle. The edge from a vertex to its next one is then the edge that leads to the vertex in the
    // cycle.
    for (std::size_t i = cycle.size(); i-- > 0;) {
        corners.push_back({cycle[i].vertex, cycle[i == 0 ? cycle.size() - 1 : i - 1].edge});
    }
}

std::size_t Polygon::index_of(const HullFeature& part, std::size_t start) const noexcept {
    const bool is_vertex = part.kind == Feature::Kind::vertex;
    std::size_t i = start;
    for (std::size_t left = corners.size(); left > 1; --left, i = next(i)) {
        if ((is_vertex ? corners[i].vertex : corners[i].edge) == part.index) break;
    }
    ECODS_ASSERT((is_vertex ? corners[i].vertex : corners[i].edge) == part.index);
    return i;
}

}  // namespace ecods::patches
