#include "query/distance/triangle_distances.hpp"

#include <algorithm>
#include <utility>

#include "exact/measure/closest_points.hpp"
#include "exact/measure/direction.hpp"
#include "exact/measure/exact_point.hpp"
#include "exact/measure/guess_features.hpp"
#include "exact/measure/measure_pair.hpp"
#include "exact/measure/polygon_order.hpp"
#include "exact/measure/shared_corners.hpp"
#include "exact/point/integer_points.hpp"

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

// ClosestPoints or FeatureNames.
template <class Closest>
void name_features(Closest& closest, const FeaturePair& f, const TrianglePair& pair) noexcept {
    using Kind = Feature::Kind;
    const bool is_vertex_of_a = f.vertex_side == 0;
    const auto name = [&](ClosestKind kind, Kind lesser, Kind greater) {
        closest.kind = kind;
        closest.a = {is_vertex_of_a ? lesser : greater, pair.a, f.a};
        closest.b = {is_vertex_of_a ? greater : lesser, pair.b, f.b};
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

FeaturePair pair_of(const FeatureNames& names) noexcept {
    return {static_cast<FeatureKind>(names.kind), static_cast<std::uint8_t>(names.a.kind > names.b.kind),
            static_cast<std::uint8_t>(names.a.corner), static_cast<std::uint8_t>(names.b.corner)};
}

}  // namespace

void TriangleDistances::bind(const BodyRef& a, const BodyRef& b) {
    points_.bind(a, b);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    for (Measured& m : measured_) m.is_known = false;
    slab_.forget();
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

// Calls use(points, features, guess) with the points of two triangles in the narrowest kernel that holds them. A guess
// that doubles prove is not asked about again.
template <class Use>
auto TriangleDistances::with_features(std::uint32_t i, std::uint32_t j, Use&& use) {
    const IntegerPair pair = integers(i, j);
    const FeaturePair features = guess_features(pair);
    const bool is_certain = enclose_distance(pair, features).is_certain;
    const ClosestFeatures guess{features, is_certain ? Standing::only : Standing::none};
    const auto in_kernel = [&]<class Kernel>(const IntegerPoints<Kernel, 6>& points) {
        const auto limbs = to_limbs(points);
        return use(points, ExactFeatures<limbs_of<Kernel>>(limbs), guess);
    };
    if (points_.is_exact()) return use_narrowest(IntegerPoints<TwoLimbKernel, 6>{pair.at, pair.unit}, in_kernel);
    PosedPoints<6> posed;
    for (std::size_t k = 0; k < 3; ++k) {
        const BodyRef &a = points_.body(0), &b = points_.body(1);
        posed[k] = {a.pose, &a.mesh->vertices()[triangles_[0][i][k]]};
        posed[3 + k] = {b.pose, &b.mesh->vertices()[triangles_[1][j][k]]};
    }
    return with_integers(posed, in_kernel);
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
            const FixedPoints::Point& p = points_.at(body, vertex);
            return ClosestSlab::Point{to_limbs(p[0]), to_limbs(p[1]), to_limbs(p[2])};
        });
    };
    return std::ranges::all_of(triangles_[0][pair.a], [&](std::uint32_t vertex) { return is_outside(0, vertex); }) &&
           std::ranges::all_of(triangles_[1][pair.b], [&](std::uint32_t vertex) { return is_outside(1, vertex); });
}

// The origin of all exact points of a pair.
PointRef TriangleDistances::first_corner(std::uint32_t i) const noexcept {
    const BodyRef& a = points_.body(0);
    return {a.pose, &a.mesh->vertices()[triangles_[0][i][0]]};
}

ClosestPoints TriangleDistances::closest(std::uint32_t i, std::uint32_t j) {
    return with_features(i, j, [&](const auto& points, const auto& features, const ClosestFeatures& guess) {
        ClosestPoints result;
        std::array<ExactPoint, 2> ends;
        SquaredDistance square;
        square.exponent = points.unit;
        const ClosestFeatures found = find_closest(points, features, guess);
        if (found.standing != Standing::none) features.measure(found.features, square);
        if (square.num.is_zero()) {
            const SharedCorners corners(features);
            result.a = {Feature::Kind::face, i, 0};
            result.b = {Feature::Kind::face, j, 0};
            corners.assign(corners.corners().front(), points.unit, ends[0]);
            result.point_a = result.point_b = round_point(first_corner(i), ends[0]);
            return result;
        }
        const FeaturePair first = first_closest(features, found);
        name_features(result, first, {i, j});
        ClosestPointsOf(features, first, points.unit).find(ends);
        result.distance = round_root(square);
        result.point_a = round_point(first_corner(i), ends[0]);
        result.point_b = round_point(first_corner(i), ends[1]);
        return result;
    });
}

void TriangleDistances::add_features(std::uint32_t i, std::uint32_t j, std::vector<FeatureNames>& to) {
    with_features(i, j, [&](const auto& points, const auto& features, const ClosestFeatures& guess) {
        const TrianglePair triangles{i, j};
        FeatureNames names{ClosestKind::intersecting, {Feature::Kind::face, i, 0}, {Feature::Kind::face, j, 0}};
        const auto add = [&](const FeaturePair& pair) {
            name_features(names, pair, triangles);
            to.push_back(names);
        };
        const ClosestFeatures found = find_closest(points, features, guess);
        SquaredDistance square;
        if (found.standing != Standing::none) features.measure(found.features, square);
        const bool are_apart = !square.num.is_zero();
        if (are_apart && found.standing == Standing::only) return add(found.features);
        const ExactSigns signs(points);
        if (!are_apart && triangle_pair(signs) == Relation::crossing) return to.push_back(names);
        for (const FeaturePair& pair : feature_pairs) {
            const Standing standing = are_apart ? features.standing(pair) : features.meeting(pair);
            if (standing >= Standing::inside) add(pair);
        }
    });
}

CloseFeatures TriangleDistances::measure(const FeatureNames& names) {
    const std::uint32_t i = names.a.triangle, j = names.b.triangle;
    if (names.kind == ClosestKind::intersecting) return {closest(i, j), std::nullopt};
    return with_features(i, j, [&](const auto& points, const auto& features, const ClosestFeatures&) {
        const FeaturePair f = pair_of(names);
        SquaredDistance square;
        square.exponent = points.unit;
        features.measure(f, square);
        std::array<ExactPoint, 2> ends;
        ClosestPointsOf(features, f, points.unit).find(ends);
        CloseFeatures result;
        result.closest = {round_root(square),
                          names.kind,
                          names.a,
                          names.b,
                          round_point(first_corner(i), ends[0]),
                          round_point(first_corner(i), ends[1])};
        const bool has_normal = f.kind == FeatureKind::vertex_face || f.kind == FeatureKind::edge_edge;
        if (has_normal || !square.num.is_zero()) {
            result.direction =
                features.with_direction(f, [](const auto& v, bool is_turned) { return round_direction(v, is_turned); });
        }
        return result;
    });
}

SharedSet TriangleDistances::intersection(std::uint32_t i, std::uint32_t j) {
    return with_features(i, j, [&](const auto& points, const auto& features, const ClosestFeatures&) {
        SharedSet result;
        const SharedCorners shared(features);
        if (const auto normal = shared.normal()) result.normal = round_direction(*normal);
        ExactPoint point;
        for (const auto& corner : corners_around(shared)) {
            shared.assign(corner, points.unit, point);
            result.all_corners[result.corner_count++] = round_point(first_corner(i), point);
        }
        return result;
    });
}

}  // namespace ecods
