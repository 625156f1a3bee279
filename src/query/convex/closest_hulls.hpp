// Where two convex solids are closest to each other, proven.
//
// Points x of the first and y of the second are closest if and only if no point of the first is beyond x along n = y -
// x, and none of the second before y. Of a convex set no vertex is beyond another if none of its neighbors is: so a
// guess of three vertices of each solid, of which the closest features are known, needs a handful of signs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/assert.hpp"
#include "ecods/closest_points.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "query/convex/gjk.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// Two triangles of vertices of the hulls, and the features of these that hold closest points. Corners may be one
// vertex.
struct HullFeatures {
    std::array<std::array<std::uint32_t, 3>, 2> corners{};
    exact::FeaturePair features;

    std::array<HullVertex, 6> vertices() const noexcept {
        return {HullVertex{0, corners[0][0]}, {0, corners[0][1]}, {0, corners[0][2]},
                {1, corners[1][0]},           {1, corners[1][1]}, {1, corners[1][2]}};
    }
    // How many corners the feature of a solid has, and the first of them; the others follow.
    std::size_t corner_count(std::size_t side) const noexcept;
    std::uint32_t corner(std::size_t side, std::size_t i) const noexcept {
        const std::size_t first = side == 0 ? features.a : features.b;
        return corners[side][(first + i) % 3];
    }
    // All of them, in their order.
    std::array<std::uint32_t, 3> of_side(std::size_t side) const noexcept {
        return {corner(side, 0), corner(side, 1), corner(side, 2)};
    }
};

// A vertex, an edge or a face of a hull.
struct HullPart {
    Feature::Kind kind = Feature::Kind::vertex;
    std::uint32_t index = 0;

    friend bool operator==(const HullPart&, const HullPart&) = default;
};

Feature part_name(const Hull& hull, const HullPart& part) noexcept;

struct ClosestHulls {
    HullFeatures found;
    // All of each solid that is furthest towards the other: the closest points are on these parts. Nothing: its feature
    // of `found`, which nobody has looked up.
    std::array<std::optional<HullPart>, 2> parts;
    // Whether the features of `found` are these parts, and hold the only closest points inside both.
    bool are_only = false;

    HullPart part(const PosedHulls& hulls, std::size_t side) const noexcept;
};

// What signs of rounded points prove of the guess, and where these leave open which vertices are as far as the
// features, exact ones. Nothing if the guess is not right, or the closest points may be on the border of a feature.
std::optional<ClosestHulls> prove_closest(PosedHulls& hulls, const Simplex& guess);
// Whether rounded points prove that the origin is inside the simplex: then the solids share a point.
bool prove_meeting(const PosedHulls& hulls, const Simplex& guess) noexcept;

// The same exactly, from any guess of at least one pair. Nothing if the solids share a point.
std::optional<ClosestHulls> find_closest_exactly(PosedHulls& hulls, const Simplex& guess);

// The closest features of two triangles of vertices, as doubles see it.
HullFeatures guess_of_triangles(PosedHulls& hulls, const std::array<std::array<std::uint32_t, 3>, 2>& corners);

// Whether features of two triangles, of vertices that are apart, hold closest points of these. Exact.
bool are_closest_of_triangles(PosedHulls& hulls, const HullFeatures& found);

// Of the direction of features, from the first solid to the second, and for the second turned back: the signs of its
// products with the ways from a vertex to others, up to signs_at_once of them. Exact.
inline constexpr std::size_t signs_at_once = 6;
std::array<int, signs_at_once> signs_beyond(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                            std::uint32_t at, std::span<const Hull::Neighbor> neighbors);

// The edges of a vertex at right angles to a direction along which the vertex is furthest: two at most, of one face.
struct LevelEdges {
    std::size_t count = 0;
    std::array<std::uint32_t, 2> edges{};

    void add(std::uint32_t edge) noexcept {
        ECODS_ASSERT(count < 2);
        if (count < 2) edges[count++] = edge;
    }
    // All of the hull that is as far.
    HullPart part(const Hull& hull, std::uint32_t vertex) const noexcept;
};

// The names of what holds the closest points by the rule of ClosestPoints, and these points.
ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest);

// Where two solids are closest, by the first of these that knows; nothing if they share a point. The witness as in
// convex_solid.hpp, or null.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, PairWitness* witness);
// The same from a pair of vertices.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, const Simplex& start, PairWitness* witness = nullptr);

// The distance, rounded once; and the sign of the distance less d.
double round_distance(PosedHulls& hulls, const HullFeatures& found);
int compare_distance(PosedHulls& hulls, const HullFeatures& found, double d);

// The face of a hull that has three vertices, which are not on one line; none (~0) if no face has.
std::uint32_t face_of(const Hull& hull, const std::array<std::uint32_t, 3>& vertices) noexcept;

// Whether an edge is of a face.
inline bool is_edge_of(const Hull& hull, std::uint32_t edge, std::uint32_t face) noexcept {
    return hull.edges[edge].faces[0] == face || hull.edges[edge].faces[1] == face;
}

}  // namespace ecods::convex
