// Finds the closest features of two convex solids, and proves them.
//
// Points x of the first solid and y of the second are closest if and only if no point of the first solid is beyond x
// along n = y - x, and no point of the second solid is before y. In a convex set, no vertex is beyond a vertex that has
// no neighbor beyond it. So a few signs suffice to prove a guess. A guess is at most three vertices of each solid whose
// closest features are known.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/short_list.hpp"
#include "ecods/ask.hpp"
#include "ecods/results.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/fixed_closest.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "query/convex/gjk.hpp"
#include "query/convex/hull_features.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {

// VertexSets holds a set of up to four vertices of each hull.
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
    // Returns a triangle of the set's vertices. Of four vertices, leaves out number `without`; of one or two vertices,
    // repeats the last one.
    std::array<std::uint32_t, 3> triangle(std::size_t side, std::size_t without = 0) const noexcept {
        std::array<std::uint32_t, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = count[side] == 4 ? i + (i >= without) : std::min(i, count[side] - 1);
            result[i] = at[side][k];
        }
        return result;
    }
};

// HullFeatures holds a feature (vertex, edge or face) of each hull, on which closest points lie. `corners[side]` is a
// triangle of hull vertices that may repeat a vertex; its first vertices are those of the feature.
struct HullFeatures {
    std::array<std::array<std::uint32_t, 3>, 2> corners{};
    exact::FeaturePair features;  // the features of the two triangles `corners`

    HullFeatures() = default;
    // Takes a feature pair of two triangles, and reorders each triangle so that the vertices of its feature come first.
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
    // Holds, for each side, the hull's feature that is extreme towards the other solid and contains the closest points.
    // An empty entry stands for the feature of `found`, whose index has not been looked up.
    std::array<std::optional<HullFeature>, 2> parts;
    // `are_only` is true if the features of `found` are these `parts`, and contain the only two closest points, in
    // their interiors.
    bool are_only = false;

    HullFeature part(const PosedHulls& hulls, std::size_t side) const noexcept;
};

// Proves the guess by signs of rounded points. If rounded points do not decide which vertices are level with the
// features, exact signs do. Returns nullopt if the guess is wrong, or if a closest point may be on the border of a
// feature.
std::optional<ClosestHulls> prove_closest(PosedHulls& hulls, const Simplex& guess);
// Returns true if rounded points prove that the origin is inside the simplex. The solids then share a point.
bool prove_meeting(const PosedHulls& hulls, const Simplex& guess) noexcept;

// Returns the closest features, found and proven in exact arithmetic. The search begins at `guess`, which may be any
// simplex of at least one pair. Returns nullopt if the solids share a point.
std::optional<ClosestHulls> find_closest_exactly(PosedHulls& hulls, const Simplex& guess);

// Returns the probable closest features of two triangles of vertices, computed in doubles without a proof.
HullFeatures guess_of_triangles(PosedHulls& hulls, const std::array<std::array<std::uint32_t, 3>, 2>& corners);

// Returns true if the features contain closest points of their two triangles, which must share no point. Exact.
bool are_closest_of_triangles(PosedHulls& hulls, const HullFeatures& found);

// Returns the exact signs of n . (neighbor - vertex `at`), for up to signs_at_once neighbors of the vertex. For the
// first solid, n is the direction from the feature of the first solid to the feature of the second; for the second
// solid, the opposite direction.
std::array<int, signs_at_once> signs_beyond(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                            std::uint32_t at, std::span<const Hull::Neighbor> neighbors);

// A HullFeaturePair is a feature of each of two solids.
using HullFeaturePair = std::array<HullFeature, 2>;

// Returns the closest points in fixed precision, named as ClosestPoints says; nullopt unless there is only one pair of
// closest points, and fixed precision decides on which features they are.
std::optional<exact::FixedClosest> find_fixed(const PosedHulls& hulls, const ClosestHulls& closest,
                                              const exact::Radii& radii);

// Returns the closest points of the features `parts` in fixed precision; nullopt if this precision does not decide. The
// features must have one pair of closest points, in the interiors of both, and be such as FixedClosest::of_features()
// takes.
std::optional<exact::FixedClosest> find_fixed(const PosedHulls& hulls, const HullFeaturePair& parts,
                                              const exact::Radii& radii);

// Chooses the features that name the closest points, by the rule of ClosestPoints, and computes these points. If radii
// are given, points and distance are those of the rounded hulls.
ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest, const exact::Radii& radii = {});

// A LeastDifference describes all pairs of points of two solids that have the least difference. If the solids share no
// point, these are the closest pairs; otherwise, the pairs that the shortest translation brings together.
struct LeastDifference {
    HullFeaturePair
        parts;  // the features that are extreme along the normal, towards each other: they contain all these pairs
    HullFeatures found;  // features that contain one of these pairs, and by which the difference is measured
    Vec3 normal;         // rounded unit vector: from the first solid to the second; for a depth, out of the first
    bool is_depth;       // true if the difference is against the normal, or zero
    bool is_zero;        // true if the depth is 0
    // `are_only` is true if `parts` have only one pair of points at the least difference, in the interiors of both.
    bool are_only = false;
};
LeastDifference least_of_closest(PosedHulls& hulls, const ClosestHulls& closest);
// Returns the least difference of two solids that share a point. `extreme` are the features that name the normal of the
// depth: a face and any feature, or two edges that are not parallel; any features of flat solids whose depth is 0.
// `normal` is the unit normal, rounded.
LeastDifference least_of_deepest(PosedHulls& hulls, const HullFeaturePair& extreme, const Vec3& normal, bool is_zero);

// Returns the square of the least difference.
exact::SquaredDistance square_of(PosedHulls& hulls, const LeastDifference& least);

// Returns an exact vector along least.normal.
exact::LongDirection exact_normal(PosedHulls& hulls, const LeastDifference& least);

// Returns the two deepest points of solids that share a point: the points that the shortest separating translation
// brings together. Chooses their features by the rule of name_closest(). The result's `distance` is the depth. If radii
// are given, points and depth are those of the rounded solids.
ClosestPoints name_deepest(PosedHulls& hulls, const LeastDifference& least, const exact::Radii& radii = {});

// Sets `pairs` to the corners of a region: all points at the least difference, projected along the normal. A corner is
// a pair of features with exactly one pair of points at the least difference, in the interior of both. The order is not
// promised. `distance` is the least difference's size, rounded once. `way` is the vector from the first to the second
// point of a pair at the least difference, in units of fixed points, if the vector is known exactly.
using LeastPairs = ShortList<HullFeaturePair, 24>;
void list_least(PosedHulls& hulls, const LeastDifference& least, double distance,
                const std::optional<exact::IntegerVector>& way, LeastPairs& pairs);

// Returns the features with the vertices by which exact functions measure them; for a face, these are its first three.
HullFeatures features_of(const PosedHulls& hulls, const HullFeaturePair& parts) noexcept;

// Returns true if the witness names two triangles.
constexpr bool is_known(const PairWitness& witness) noexcept {
    return witness.a != PairWitness::none && witness.b != PairWitness::none;
}

// A QuickClosest has what doubles show of two solids: a guess of the closest features; the closest features, if they
// are proven; and whether it is proven that the solids share a point.
struct QuickClosest {
    Simplex guess;
    std::optional<ClosestHulls> closest;
    bool do_meet = false;

    // Returns true if neither closest features nor a common point are proven, and the guess is so near that the solids
    // may share a point. This test is a heuristic.
    bool may_touch(const PosedHulls& hulls) const noexcept;
};
// `witness` is as in solid.hpp, or null.
QuickClosest find_quickly(PosedHulls& hulls, const PairWitness* witness);

// Returns the closest features of two solids, by the cheapest of the functions above that succeeds; nullopt if the
// solids share a point. `witness` is as in solid.hpp, or null.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, PairWitness* witness);
// Returns the closest features, continuing from the result `found` of find_quickly().
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, const QuickClosest& found, PairWitness* witness);
// Returns the closest features, beginning the search at the simplex `start`.
std::optional<ClosestHulls> find_closest(PosedHulls& hulls, const Simplex& start, PairWitness* witness = nullptr);

// Measure the features `found` exactly. The functions return their squared distance; their distance, rounded once; the
// unit vector from the first to the second, rounded once (the features must share no point); and the sign of (distance
// - d).
exact::SquaredDistance square_of(PosedHulls& hulls, const HullFeatures& found);
double round_distance(PosedHulls& hulls, const HullFeatures& found);
Vec3 round_direction(PosedHulls& hulls, const HullFeatures& found);
int compare_distance(PosedHulls& hulls, const HullFeatures& found, double d);

}  // namespace ecods::convex
