// A FeatureKey identifies a vertex, edge or face of a mesh. rank() orders pairs of features, to choose among pairs that
// tie.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <tuple>

#include "ecods/results.hpp"

namespace ecods {

// Identifies a vertex or an edge by its vertices, and a face by its triangle. All triangles that share a feature give
// the same key.
struct FeatureKey {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    // first and second are, for a vertex, its index and `none`; for an edge, the indices of its two vertices, the
    // lesser first; for a face, the index of its triangle twice. The two vertices of an edge differ, so a face never
    // has the key of an edge.
    std::uint32_t first = none;
    std::uint32_t second = none;

    bool is_vertex() const noexcept { return second == none; }
    friend auto operator<=>(const FeatureKey&, const FeatureKey&) = default;
};

// Returns the key of a feature of a triangle whose vertices are `corners`.
inline FeatureKey feature_key(const Feature& feature, const Triangle& corners) noexcept {
    const std::uint32_t corner = corners[feature.corner], next = corners[(feature.corner + 1) % 3];
    switch (feature.kind) {
        case Feature::Kind::vertex:
            return {corner, FeatureKey::none};
        case Feature::Kind::edge:
            return {std::min(corner, next), std::max(corner, next)};
        default:
            return {feature.triangle, feature.triangle};
    }
}

// Returns the feature with this key, named by `triangle`, which must have it, and by its lowest corner there. `corners`
// are the triangle's vertices.
inline Feature feature_of(const FeatureKey& key, std::uint32_t triangle, const Triangle& corners) noexcept {
    if (key.first == key.second) return {Feature::Kind::face, triangle, 0};
    Feature result{key.is_vertex() ? Feature::Kind::vertex : Feature::Kind::edge, triangle, 0};
    while (feature_key(result, corners) != key) ++result.corner;
    return result;
}

// Names one feature of each of two meshes: a triangle that has the feature, and a corner. If `kind` is intersecting, a
// and b are faces.
struct FeatureNames {
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;

    friend bool operator==(const FeatureNames&, const FeatureNames&) = default;
};

// Returns the rank of a pair of features: among pairs that tie, the pair of the least rank is chosen. Pair is any type
// with members kind, a and b. ClosestPoints, FirstContact and close_features() promise this order.
template <class Pair>
auto rank(const Pair& f) noexcept {
    return std::tuple(f.kind, f.a.triangle, f.a.corner, f.b.triangle, f.b.corner, f.a.kind);
}

}  // namespace ecods
