// Vertices, edges and faces of a hull: their names, and which of them is furthest along a direction.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "base/assert.hpp"
#include "query/convex/hull.hpp"

namespace ecods::convex {

// A vertex, an edge or a face of a hull, by its index.
struct HullFeature {
    Feature::Kind kind = Feature::Kind::vertex;
    std::uint32_t index = 0;

    friend bool operator==(const HullFeature&, const HullFeature&) = default;
};

Feature name_of(const Hull& hull, const HullFeature& feature) noexcept;

// The edge between two vertices that have one.
std::uint32_t edge_of(const Hull& hull, std::uint32_t from, std::uint32_t to) noexcept;
// The face of a hull that has three vertices, which are not on one line; none (~0) if no face has.
std::uint32_t face_of(const Hull& hull, const std::array<std::uint32_t, 3>& vertices) noexcept;

inline bool is_edge_of(const Hull& hull, std::uint32_t edge, std::uint32_t face) noexcept {
    return hull.edges[edge].faces[0] == face || hull.edges[edge].faces[1] == face;
}

// The edges of a vertex at right angles to a direction along which the vertex is furthest: two at most, of one face.
struct LevelEdges {
    std::size_t count = 0;
    std::array<std::uint32_t, 2> edges{};

    void add(std::uint32_t edge) noexcept {
        ECODS_ASSERT(count < 2);
        if (count < 2) edges[count++] = edge;
    }
    // The vertex, the edge or the face that is as far as the vertex.
    HullFeature feature(const Hull& hull, std::uint32_t vertex) const noexcept;
};

// A vertex than which none is further along a direction, and its edges at right angles to that.
struct Furthest {
    std::uint32_t vertex;
    LevelEdges level;
};

// How many neighbors a climb asks about at a time.
inline constexpr std::size_t signs_at_once = 6;

// Goes to a neighbor that is further along a direction, if there is one; otherwise `at` knows which are as far: of a
// convex set two at most, as they are on one face. signs(vertex, neighbors) has the signs of how much further than the
// vertex they are, as an array of signs_at_once; behind a positive one it may have anything.
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

// Each step goes further, so it ends; and of a convex set no vertex is further than one that is beyond no neighbor.
template <class Signs>
Furthest climb(const Hull& hull, std::uint32_t start, const Signs& signs) {
    Furthest result{start, {}};
    while (climb_once(hull, result, signs)) {
    }
    return result;
}

}  // namespace ecods::convex
