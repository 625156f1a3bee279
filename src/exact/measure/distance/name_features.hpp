// name_features converts a FeaturePair to public names of features (ecods/results.hpp).
#pragma once

#include "ecods/results.hpp"
#include "exact/measure/distance/feature_pair.hpp"

namespace ecods::exact {

static_assert(static_cast<int>(ClosestKind::vertex_vertex) == static_cast<int>(FeatureKind::vertex_vertex));
static_assert(static_cast<int>(ClosestKind::vertex_edge) == static_cast<int>(FeatureKind::vertex_edge));
static_assert(static_cast<int>(ClosestKind::vertex_face) == static_cast<int>(FeatureKind::vertex_face));
static_assert(static_cast<int>(ClosestKind::edge_edge) == static_cast<int>(FeatureKind::edge_edge));

// Returns the public name of f's feature of triangle `side` (0 or 1); `triangle` is that triangle's index in its mesh.
inline Feature feature_of(const FeaturePair& f, std::size_t side, std::uint32_t triangle) noexcept {
    return {static_cast<Feature::Kind>(f.corner_count(side) - 1), triangle, static_cast<std::uint32_t>(f.corner(side))};
}

// Sets names.kind, names.a and names.b to the features f. `pair` has the triangles' indices in their meshes.
template <class Names>
void name_features(Names& names, const FeaturePair& f, const TrianglePair& pair) noexcept {
    names.kind = static_cast<ClosestKind>(f.kind);
    names.a = feature_of(f, 0, pair.a);
    names.b = feature_of(f, 1, pair.b);
}

// Returns the FeaturePair from which name_features() set `names`. The kind must not be `intersecting`.
template <class Names>
FeaturePair features_named(const Names& names) noexcept {
    return pair_of(static_cast<FeatureKind>(names.kind), names.a.kind > names.b.kind, names.a.corner, names.b.corner);
}

}  // namespace ecods::exact
