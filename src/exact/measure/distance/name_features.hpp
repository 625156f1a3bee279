// The public names of features of two triangles.
#pragma once

#include "ecods/closest_points.hpp"
#include "exact/measure/distance/feature_pair.hpp"

namespace ecods::exact {

// Of anything with a kind and features a and b; as the triangles of the pair give them.
template <class Names>
void name_features(Names& names, const FeaturePair& f, const TrianglePair& pair) noexcept {
    using Kind = Feature::Kind;
    const bool is_lesser_of_a = f.vertex_side == 0;
    const auto name = [&](ClosestKind kind, Kind lesser, Kind greater) {
        names.kind = kind;
        names.a = {is_lesser_of_a ? lesser : greater, pair.a, f.a};
        names.b = {is_lesser_of_a ? greater : lesser, pair.b, f.b};
    };
    switch (f.kind) {
        case FeatureKind::vertex_vertex:
            return name(ClosestKind::vertex_vertex, Kind::vertex, Kind::vertex);
        case FeatureKind::vertex_edge:
            return name(ClosestKind::vertex_edge, Kind::vertex, Kind::edge);
        case FeatureKind::vertex_face:
            return name(ClosestKind::vertex_face, Kind::vertex, Kind::face);
        case FeatureKind::edge_edge:
            return name(ClosestKind::edge_edge, Kind::edge, Kind::edge);
    }
}

}  // namespace ecods::exact
