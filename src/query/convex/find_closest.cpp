// Searches exactly for the closest features. Each round finds the closest features of two simplices of vertices, in
// integers. If no vertex is beyond these features, they are the closest features of the solids. Otherwise the vertices
// furthest beyond are added to the simplices.
//
// In each round the distance of the simplices decreases, because the added vertex brings them closer. So no pair of
// simplices occurs twice. The distance is computed as the distance of the simplices' triangles. It is larger than the
// distance of the simplices only if one simplex is inside the other; so if it does not decrease, the solids share a
// point.
#include <algorithm>
#include <span>

#include "exact/measure/distance/fixed_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/round/direction.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/exact_hulls.hpp"

namespace ecods::convex {
namespace {

using exact::Limbs;
using exact::SquaredDistance;

struct Measured {
    HullFeatures found;
    SquaredDistance square;
};

// Sets `result` to the closest features and the squared distance of two triangles; the square is zero if they share a
// point.
void measure(PosedHulls& hulls, const std::array<std::array<std::uint32_t, 3>, 2>& triangles, Measured& result) {
    result.found = guess_of_triangles(hulls, triangles);
    with_exact_features(hulls, result.found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        const exact::ClosestFeatures closest =
            exact::find_closest(points, features, {result.found.features, exact::Standing::none});
        result.square.exponent = points.unit;
        if (closest.standing == exact::Standing::none) {
            result.square.num = {};
            return;
        }
        features.measure(closest.features, result.square);
        result.found = {result.found.corners, closest.features};
    });
}

// Measures the distances of all pairs of triangles of the two vertex sets. Sets `least` to the result with the least
// distance; `other` is scratch.
void measure_all(PosedHulls& hulls, const VertexSets& sets, Measured& least, Measured& other) {
    bool is_first = true;
    for (std::size_t i = 0; i < sets.triangle_count(0); ++i) {
        for (std::size_t k = 0; k < sets.triangle_count(1); ++k) {
            Measured& result = is_first ? least : other;
            measure(hulls, {sets.triangle(0, i), sets.triangle(1, k)}, result);
            if (!is_first && compare(other.square, least.square) < 0) std::swap(least, other);
            is_first = false;
            if (least.square.num.is_zero()) return;
        }
    }
}

// Returns the vertex of solid `side` that is furthest towards the other solid, along the vector between the closest
// points of the features `found`.
Furthest find_furthest(PosedHulls& hulls, const HullFeatures& found, std::size_t side) {
    return climb(hulls.hull(side), found.corners[side][0],
                 [&](std::uint32_t at, std::span<const Hull::Neighbor> neighbors) {
                     return signs_beyond(hulls, found, side, at, neighbors);
                 });
}

template <std::size_t N>
std::array<int, signs_at_once> find_signs(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                          std::uint32_t at, std::span<const Hull::Neighbor> neighbors) {
    std::array<HullVertex, 7 + N> vertices;
    std::ranges::copy(found.vertices(), vertices.begin());
    std::fill(vertices.begin() + 6, vertices.end(), HullVertex{side, at});
    for (std::size_t i = 0; i < neighbors.size(); ++i) vertices[7 + i].vertex = neighbors[i].vertex;
    return with_exact_features(
        hulls, vertices, [&]<int L>(const auto&, const exact::ExactFeatures<L>& features, const auto& limbs) {
            return features.with_direction(found.features, [&]<int M>(const exact::LimbVector<M>& n, bool is_turned) {
                std::array<int, signs_at_once> signs{};
                for (std::size_t i = 0; i < neighbors.size(); ++i) {
                    const auto way = exact::difference<L>(limbs[7 + i], limbs[6]);
                    const int sign = exact::sign<M + L>(exact::dot<M, L>(n, way));
                    signs[i] = is_turned == (side == 0) ? -sign : sign;
                }
                return signs;
            });
        });
}

// Returns the distance of the features in fixed precision, rounded once; nullopt if the rounding is not certain.
std::optional<double> round_from_digits(PosedHulls& hulls, const HullFeatures& found) {
    const auto points = hulls.integers({found.of_side(0), found.of_side(1)});
    exact::IntegerPair pair{{}, points.unit, points.are_exact ? 0 : exact::IntegerFrame::error_units};
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < found.of_side(side).size(); ++i) pair.at[3 * side + i] = points.at[side][i];
    }
    return exact::fixed_distance(pair, found.features);
}

}  // namespace

HullFeatures guess_of_triangles(PosedHulls& hulls, const std::array<std::array<std::uint32_t, 3>, 2>& corners) {
    const HullFeatures any(corners, {});
    if (!hulls.has_fixed_points()) return any;
    const auto vertices = any.vertices();
    exact::IntegerPair pair{{}, hulls.fixed_unit(), 0};
    for (std::size_t i = 0; i < 6; ++i) pair.at[i] = hulls.fixed(vertices[i]);
    return {corners, exact::guess_features(pair)};
}

bool are_closest_of_triangles(PosedHulls& hulls, const HullFeatures& found) {
    return with_exact_features(hulls, found.vertices(), [&](const auto&, const auto& features, const auto&) {
        return features.standing(found.features) != exact::Standing::none;
    });
}

std::array<int, signs_at_once> signs_beyond(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                            std::uint32_t at, std::span<const Hull::Neighbor> neighbors) {
    ECODS_ASSERT(neighbors.size() <= signs_at_once);
    return neighbors.size() <= 2 ? find_signs<2>(hulls, found, side, at, neighbors)
                                 : find_signs<signs_at_once>(hulls, found, side, at, neighbors);
}

std::optional<ClosestHulls> find_closest_exactly(PosedHulls& hulls, const Simplex& guess) {
    VertexSets sets(guess);
    Measured least, other;
    SquaredDistance last;
    for (bool is_first = true;; is_first = false) {
        measure_all(hulls, sets, least, other);
        if (least.square.num.is_zero()) return std::nullopt;
        if (!is_first && compare(least.square, last) >= 0) return std::nullopt;
        last = least.square;
        std::array<std::optional<HullFeature>, 2> parts;
        sets = {};
        bool are_closest = true;
        for (const std::size_t side : {0, 1}) {
            const auto corners = least.found.of_side(side);
            for (const std::uint32_t vertex : corners) sets.add(side, vertex);
            const Furthest furthest = find_furthest(hulls, least.found, side);
            parts[side] = furthest.level.feature(hulls.hull(side), furthest.vertex);
            sets.add(side, furthest.vertex);
            are_closest &= sets.count[side] == corners.size();
        }
        if (are_closest) return ClosestHulls{least.found, parts, false};
    }
}

SquaredDistance square_of(PosedHulls& hulls, const HullFeatures& found) {
    return with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        SquaredDistance square;
        square.exponent = points.unit;
        features.measure(found.features, square);
        return square;
    });
}

double round_distance(PosedHulls& hulls, const HullFeatures& found) {
    if (const auto distance = round_from_digits(hulls, found)) return *distance;
    return exact::round_root(square_of(hulls, found));
}

Vec3 round_direction(PosedHulls& hulls, const HullFeatures& found) {
    return with_exact_features(hulls, found.vertices(), [&](const auto&, const auto& features, const auto&) {
        return features.with_direction(
            found.features, [](const auto& n, bool is_turned) { return exact::round_direction(n, is_turned); });
    });
}

int compare_distance(PosedHulls& hulls, const HullFeatures& found, double d) {
    return exact::compare(square_of(hulls, found), d);
}

}  // namespace ecods::convex
