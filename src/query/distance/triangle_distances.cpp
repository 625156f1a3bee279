#include "query/distance/triangle_distances.hpp"

#include <algorithm>
#include <utility>

#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "query/distance/triangle_features.hpp"

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
SharedFeature shared_face(std::uint32_t triangle) noexcept {
    return {triangle, triangle};
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
            interval.a = is_vertex_of_a ? shared_vertex(a, f.a) : shared_face(pair.a);
            interval.b = is_vertex_of_a ? shared_face(pair.b) : shared_vertex(b, f.b);
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
    points_.bind_pair(a, b);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    for (Measured& m : measured_) m.is_known = false;
    slab_.forget();
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

const TriangleDistances::Measured& TriangleDistances::measured(const TrianglePair& pair) {
    if (measured_[1].is_known && measured_[1].pair == pair) std::swap(measured_[0], measured_[1]);
    if (measured_[0].is_known && measured_[0].pair == pair) return measured_[0];
    std::swap(measured_[0], measured_[1]);
    Measured& result = measured_[0];
    result.pair = pair;
    result.is_known = true;
    with_features(pair.a, pair.b, [&](const auto& points, const auto& features, const ClosestFeatures& guess) {
        const ClosestFeatures found = find_closest(points, features, guess);
        result.square.exponent = points.unit;
        if (found.standing == Standing::none) {
            result.square.num = {};
            result.square.den = Natural<denominator_limbs>(1);
        } else {
            features.measure(found.features, result.square);
            result.features = found.features;
        }
    });
    return result;
}

double TriangleDistances::distance(std::uint32_t i, std::uint32_t j) {
    return round_root(measured({i, j}).square);
}

int TriangleDistances::compare(std::uint32_t i, std::uint32_t j, double d) {
    return exact::compare(measured({i, j}).square, d);
}

int TriangleDistances::compare(const TrianglePair& first, const TrianglePair& second) {
    measured(first);
    const SquaredDistance& b = measured(second).square;
    const SquaredDistance& a = first == second ? b : measured_[1].square;
    return exact::compare(a, b);
}

void TriangleDistances::refer_to(const TrianglePair& pair) {
    slab_.forget();
    const FeaturePair f = measured(pair).features;
    if (!points_.is_exact() || measured(pair).square.num.is_zero()) return;
    const auto points = to_limbs(IntegerPoints<TwoLimbKernel, 6>{integers(pair.a, pair.b).at, points_.unit()});
    ExactFeatures<ClosestSlab::limb_count>(points).with_direction(
        f, [&](const auto& n, bool is_turned) { slab_.set(n, is_turned, points[f.a], points[3 + f.b]); });
}

bool TriangleDistances::is_not_nearer(const TrianglePair& pair) {
    if (!slab_.is_set()) return false;
    const auto is_outside = [&](std::size_t body, std::uint32_t vertex) {
        return slab_.is_outside(body, vertex, [&] {
            const IntegerFrame::Point& p = points_.at(body, vertex);
            return ClosestSlab::Point{to_limbs(p[0]), to_limbs(p[1]), to_limbs(p[2])};
        });
    };
    return std::ranges::all_of(triangles_[0][pair.a], [&](std::uint32_t vertex) { return is_outside(0, vertex); }) &&
           std::ranges::all_of(triangles_[1][pair.b], [&](std::uint32_t vertex) { return is_outside(1, vertex); });
}

}  // namespace ecods
