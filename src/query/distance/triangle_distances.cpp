#include "query/distance/triangle_distances.hpp"

#include <algorithm>

namespace ecods {

using namespace exact;

namespace {

SharedFeature shared_vertex(const Triangle& triangle, std::size_t corner) noexcept {
    return {triangle[corner], SharedFeature::none};
}
SharedFeature shared_edge(const Triangle& triangle, std::size_t corner) noexcept {
    const std::uint32_t from = triangle[corner], to = triangle[corner == 2 ? 0 : corner + 1];
    return {std::min(from, to), std::max(from, to)};
}

void name_features(DistanceInterval& interval, const FeaturePair& f, const TrianglePair& pair, const Triangle& a,
                   const Triangle& b) noexcept {
    const bool is_vertex_of_a = f.vertex_side == 0;
    switch (f.kind) {
        case FeatureKind::vertex_vertex:
            interval.kind = ClosestKind::vertex_vertex;
            interval.a = shared_vertex(a, f.a);
            interval.b = shared_vertex(b, f.b);
            return;
        case FeatureKind::vertex_edge:
            interval.kind = ClosestKind::vertex_edge;
            interval.a = is_vertex_of_a ? shared_vertex(a, f.a) : shared_edge(a, f.a);
            interval.b = is_vertex_of_a ? shared_edge(b, f.b) : shared_vertex(b, f.b);
            return;
        case FeatureKind::vertex_face:
            interval.kind = ClosestKind::vertex_face;
            interval.a = is_vertex_of_a ? shared_vertex(a, f.a) : SharedFeature{pair.a, SharedFeature::none};
            interval.b = is_vertex_of_a ? SharedFeature{pair.b, SharedFeature::none} : shared_vertex(b, f.b);
            return;
        case FeatureKind::edge_edge:
            interval.kind = ClosestKind::edge_edge;
            interval.a = shared_edge(a, f.a);
            interval.b = shared_edge(b, f.b);
            return;
    }
}

}  // namespace

void TriangleDistances::bind(const BodyRef& a, const BodyRef& b) {
    points_.bind(a, b);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
}

ECODS_ALWAYS_INLINE IntegerPair TriangleDistances::integers(std::uint32_t i, std::uint32_t j) {
    IntegerPair pair;
    for (std::size_t k = 0; k < 3; ++k) {
        pair.at[k] = points_.at(0, triangles_[0][i][k]);
        pair.at[3 + k] = points_.at(1, triangles_[1][j][k]);
    }
    pair.unit = points_.unit();
    pair.error = points_.is_exact() ? 0 : FixedPoints::error_units;
    return pair;
}

DistanceInterval TriangleDistances::enclose(std::uint32_t i, std::uint32_t j) {
    const IntegerPair pair = integers(i, j);
    const FeaturePair features = guess_features(pair);
    const Enclosure enclosure = enclose_distance(pair, features);
    DistanceInterval interval{
        enclosure.lower, enclosure.upper, enclosure.is_certain, ClosestKind::intersecting, {}, {}};
    if (enclosure.is_certain) name_features(interval, features, {i, j}, triangles_[0][i], triangles_[1][j]);
    return interval;
}

}  // namespace ecods
