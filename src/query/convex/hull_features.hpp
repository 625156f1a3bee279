// Names vertices, edges and faces of a hull, and finds the feature that is extreme along a direction.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/assert.hpp"
#include "query/convex/hull.hpp"

namespace ecods::convex {

// A HullFeature refers to a vertex, an edge or a face of a hull, by its index.
struct HullFeature {
    Feature::Kind kind = Feature::Kind::vertex;
    std::uint32_t index = 0;

    friend bool operator==(const HullFeature&, const HullFeature&) = default;
};

Feature name_of(const Hull& hull, const HullFeature& feature) noexcept;

// Returns the edge between two vertices, which must be neighbors.
std::uint32_t edge_of(const Hull& hull, std::uint32_t from, std::uint32_t to) noexcept;
// Returns the face that contains three vertices, which must not be on one line; ~0 if there is no such face.
std::uint32_t face_of(const Hull& hull, const std::array<std::uint32_t, 3>& vertices) noexcept;

inline bool is_edge_of(const Hull& hull, std::uint32_t edge, std::uint32_t face) noexcept {
    return hull.edges[edge].faces[0] == face || hull.edges[edge].faces[1] == face;
}

// LevelEdges holds the edges of an extreme vertex that are perpendicular to the direction along which the vertex is
// extreme. There are at most two; two are edges of one face.
struct LevelEdges {
    std::size_t count = 0;
    std::array<std::uint32_t, 2> edges{};

    void add(std::uint32_t edge) noexcept {
        ECODS_ASSERT(count < 2);
        if (count < 2) edges[count++] = edge;
    }
    // Returns the vertex, edge or face whose points are all as far along the direction as the vertex.
    HullFeature feature(const Hull& hull, std::uint32_t vertex) const noexcept;
};

// A Furthest is a vertex that is extreme along a direction, and its edges that are perpendicular to the direction.
struct Furthest {
    std::uint32_t vertex;
    LevelEdges level;
};

// signs_at_once is the number of neighbors whose signs a climb computes at once.
inline constexpr std::size_t signs_at_once = 6;

// Moves `at` to a neighbor that is further along a direction, and returns true. If there is no such neighbor, returns
// false, and sets at.level to the edges to neighbors that are as far as the vertex. In a convex set there are at most
// two, of one face.
//
// signs(vertex, neighbors) must return, as an array of signs_at_once, the sign of (height of the neighbor - height of
// the vertex) for each neighbor. Signs after the first positive one are ignored.
template <class Signs>
bool climb_once(const Hull& hull, Furthest& at, const Signs& signs) {
    at.level = {};
    const auto neighbors = hull.neighbors_of(at.vertex);
    for (std::size_t first = 0; first < neighbors.size(); first += signs_at_once) {
        const auto some = neighbors.subspan(first, std::min(signs_at_once, neighbors.size() - first));
        const std::array<int, signs_at_once> found = signs(at.vertex, some);
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (found[i] > 0) {
                at.vertex = some[i].vertex;
                return true;
            }
            if (found[i] == 0) at.level.add(some[i].edge);
        }
    }
    return false;
}

// Climbs from `start` to an extreme vertex. The climb ends because each step goes further. In a convex set, a vertex is
// extreme if no neighbor is beyond it.
template <class Signs>
Furthest climb(const Hull& hull, std::uint32_t start, const Signs& signs) {
    Furthest result{start, {}};
    while (climb_once(hull, result, signs)) {
    }
    return result;
}

}  // namespace ecods::convex
