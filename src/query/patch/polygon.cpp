#include "query/patch/polygon.hpp"

#include <algorithm>

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
        corners.assign(cycle.begin(), cycle.end());
        return;
    }
    // Reverses the cycle. The edge from a vertex to its next one is then the edge that leads to the vertex in the
    // cycle.
    for (std::size_t i = cycle.size(); i-- > 0;) {
        corners.push_back({cycle[i].vertex, cycle[i == 0 ? cycle.size() - 1 : i - 1].edge});
    }
}

std::size_t Polygon::index_of(const HullFeature& part) const noexcept {
    const bool is_vertex = part.kind == Feature::Kind::vertex;
    const auto found = std::ranges::find_if(corners, [&](const convex::Hull::Neighbor& corner) {
        return (is_vertex ? corner.vertex : corner.edge) == part.index;
    });
    ECODS_ASSERT(found != corners.end());
    return static_cast<std::size_t>(found - corners.begin());
}

}  // namespace ecods::patches
