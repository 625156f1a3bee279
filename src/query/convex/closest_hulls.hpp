// Where two convex solids are closest to each other, proven.
//
// Points x of the first and y of the second are closest if and only if no point of the first is beyond x along n = y -
// x, and none of the second before y. Of a convex set no vertex is beyond another if none of its neighbors is: so a
// guess of three vertices of each solid, of which the closest features are known, needs a handful of signs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "ecods/closest_points.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "query/convex/gjk.hpp"
#include "query/convex/hull_features.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// Sets of up to four vertices of each hull.
struct VertexSets {
    std::array<std::array<std::uint32_t, 4>, 2> at{};
    std::array<std::size_t, 2> count{};

    VertexSets() = default;
    explicit VertexSets(const Simplex& simplex) noexcept;

    void add(std::size_t side, std::uint32_t vertex) noexcept {
        const auto end = at[side].begin() + static_cast<std::ptrdiff_t>(count[side]);
        if (std::find(at[side].begin(), end, vertex) == end) at[side][count[side]++] = vertex;
    }
    std::size_t triangle_count(std::size_t side) const noexcept { return count[side] == 4 ? 4 : 1; }
    // A triangle has all of four vertices but one; otherwise all, the last one more than once if they are less than
    // three.
    std::array<std::uint32_t, 3> triangle(std::size_t side, std::size_t without = 0) const noexcept {
        std::array<std::uint32_t, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = count[side] == 4 ? i + (i >= without) : std::min(i, count[side] - 1);
            result[i] = at[side][k];
        }
        return result;
    }
};

// A vertex, an edge or a face of each hull that hold closest points: their vertices are the first ones of a triangle of
// vertices, which may be one vertex more than once.
struct HullFeatures {
    std::array<std::array<std::uint32_t, 3>, 2> corners{};
    exact::FeaturePair features;  // of the triangles

    HullFeatures() = default;
    // Features of two triangles, whichever of their corners they have.
    HullFeatures(const std::array<std::array<std::uint32_t, 3>, 2>& triangles, const exact::FeaturePair& f) noexcept;

    std::array<HullVertex, 6> vertices() const noexcept {
        return {HullVertex{0, corners[0][0]}, {0, corners[0][1]}, {0, corners[0][2]},
                {1, corners[1][0]},           {1, corners[1][1]}, {1, corners[1][2]}};
    }
    std::span<const std::uint32_t> of_side(std::size_t side) const noexcept {
        return {corners[side].data(), features.corner_count(side)};
    }
};

struct ClosestHulls {
    HullFeatures found;
    // A part is all of a solid that is furthest towards the other: the closest points are on both parts. Nothing: its
    // feature of `found`, which nobody has looked up.
    std::array<std::optional<HullFeature>, 2> parts;
    // Whether the features of `found` are these parts, and hold the only closest points inside both.
    bool are_only = false;

    HullFeature part(const PosedHulls& hulls, std::size_t side) const noexcept;
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
std::array<int, signs_at_once> signs_beyond(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                            std::uint32_t at, std::span<const Hull::Neighbor> neighbors);

// The names of what holds the closest points by the rule of ClosestPoints, and these points.
ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest);

// Where two solids are closest, by the first of these that knows; nothing if they share a point. The witness as in
// convex_solid.hpp, or null.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, PairWitness* witness);
// The same from a pair of vertices.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, const Simplex& start, PairWitness* witness = nullptr);

// The squared distance, exactly; the distance, rounded once; and the sign of the distance less d.
exact::SquaredDistance square_of(PosedHulls& hulls, const HullFeatures& found);
double round_distance(PosedHulls& hulls, const HullFeatures& found);
int compare_distance(PosedHulls& hulls, const HullFeatures& found, double d);

}  // namespace ecods::convex
