// Features have keys, and pairs of features an order in which one of several is chosen.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <tuple>

#include "ecods/results.hpp"

namespace ecods {

// Names a vertex, an edge or a face by its vertices or its triangle: the same key from every triangle that has the
// feature.
struct FeatureKey {
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    // A vertex has its index and none; an edge the indices of its two vertices, the lesser first; a face its triangle's
    // index twice. Ends of an edge differ, so a face never has the key of a vertex or an edge.
    std::uint32_t first = none;
    std::uint32_t second = none;

    bool is_vertex() const noexcept { return second == none; }
    friend auto operator<=>(const FeatureKey&, const FeatureKey&) = default;
};

// Returns the key of a feature of a triangle with these corners.
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

// Returns the feature with this key, by its least corner in a triangle that has it.
inline Feature feature_of(const FeatureKey& key, std::uint32_t triangle, const Triangle& corners) noexcept {
    if (key.first == key.second) return {Feature::Kind::face, triangle, 0};
    Feature result{key.is_vertex() ? Feature::Kind::vertex : Feature::Kind::edge, triangle, 0};
    while (feature_key(result, corners) != key) ++result.corner;
    return result;
}

// Names a feature of each of two meshes, by a triangle that has it and a corner; `intersecting` names two faces.
struct FeatureNames {
    ClosestKind kind = ClosestKind::intersecting;
    Feature a, b;

    friend bool operator==(const FeatureNames&, const FeatureNames&) = default;
};

// Returns the rank of a pair of features: among pairs that tie, the least rank is chosen. The pair is anything with a
// kind and two features. ClosestPoints, FirstContact and close_features() promise this order.
template <class Pair>
auto rank(const Pair& f) noexcept {
    return std::tuple(f.kind, f.a.triangle, f.a.corner, f.b.triangle, f.b.corner, f.a.kind);
}

}  // namespace ecods
