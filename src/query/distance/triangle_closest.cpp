#include <array>

#include "base/double_key.hpp"
#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/measure/distance/set_ends.hpp"
#include "exact/measure/distance/shared_corners.hpp"
#include "exact/measure/round/direction.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/distance/triangle_features.hpp"

namespace ecods {

using namespace exact;

// Returns the first corner of triangle i, which is the origin of the exact points of all pairs with this triangle.
PointRef TriangleDistances::first_corner(std::uint32_t i) const noexcept {
    const BodyRef& a = points_.body(0);
    return {a.pose, &a.mesh->vertices()[triangles_[0][i][0]]};
}

std::optional<FixedClosest> TriangleDistances::find_fixed(std::uint32_t i, std::uint32_t j, const Radii& radii) {
    const IntegerPair pair = integers(i, j);
    const FeaturePair found = guess_features(pair);
    if (!enclose_distance(pair, found).is_certain) return std::nullopt;
    std::array<PosedFeature, 2> features;
    for (const std::size_t side : {0, 1}) {
        const BodyRef& body = points_.body(side);
        const Triangle& corners = triangles_[side][side == 0 ? i : j];
        features[side] = {body.pose, {}, found.corner_count(side)};
        for (std::size_t k = 0; k < features[side].count; ++k) {
            features[side].corners[k] = &body.mesh->vertices()[corners[(found.corner(side) + k) % 3]];
        }
    }
    FixedClosest::Names names;
    name_features(names, found, {i, j});
    return FixedClosest::of_features(features, radii, names);
}

ClosestPoints TriangleDistances::closest(std::uint32_t i, std::uint32_t j, const Radii& radii, PointA point_a) {
    const std::optional<FixedClosest> fixed = find_fixed(i, j, radii);
    if (auto points = fixed ? fixed->signed_closest() : std::nullopt) {
        points->distance = positive_part(points->distance);
        return *points;
    }
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
            corners.corners().front().assign_to(ends[0], points.unit);
            result.point_a = result.point_b = round_point(first_corner(i), ends[0]);
            return result;
        }
        const FeaturePair first = first_closest(features, found);
        name_features(result, first, {i, j});
        find_closest_points(features, first, points.unit, ends);
        if (point_a == PointA::left_out) {
            result.distance = round_root(square);
            result.point_b = round_point(first_corner(i), ends[1]);
        } else {
            set_ends(result, square, first_corner(i), ends, features, first, radii);
        }
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
        const FeaturePair f = features_named(names);
        SquaredDistance square;
        square.exponent = points.unit;
        features.measure(f, square);
        std::array<ExactPoint, 2> ends;
        find_closest_points(features, f, points.unit, ends);
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

}  // namespace ecods
