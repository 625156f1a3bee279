#include "exact/measure/distance/fixed_closest.hpp"

#include <algorithm>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "base/next.hpp"
#include "exact/number/power.hpp"
#include "exact/point/segment_ends.hpp"

namespace ecods::exact {
namespace {

SegmentRef segment_of(const PosedFeature& feature) noexcept {
    return {feature.pose, feature.corners[0], feature.corners[feature.count == 1 ? 0 : 1]};
}

// Returns two segments whose closest points determine the closest points of the features: for vertices and edges, the
// features themselves; for a vertex and a face, see exact/point/segment_ends.hpp.
SegmentEnds ends_of(const std::array<PosedFeature, 2>& features, int high) noexcept {
    for (const std::size_t side : {0, 1}) {
        if (features[side].count != 3) continue;
        const PosedFeature &face = features[side], &vertex = features[1 - side];
        return {PointAndTriangle{vertex.pose, vertex.corners[0], face.pose, face.corners}, side, high};
    }
    return {segment_of(features[0]), segment_of(features[1]), high};
}

// Replaces the closest points of the two auxiliary segments of a vertex and a face (segment_ends.hpp) by the vertex and
// its foot in the face.
void move_to_features(ClosestOnSegments& at, const SegmentEnds& ends, std::size_t of_face) noexcept {
    const std::size_t of_vertex = 1 - of_face;
    const auto w = difference(at.point[of_face], at.point[of_vertex]);
    at.point[of_vertex] = ends.at[of_vertex][0];
    for (std::size_t k = 0; k < 3; ++k) {
        at.point[of_face][k] = at.point[of_vertex][k] + w[k];
        const auto of_point = static_cast<std::uint64_t>(ends.error());
        const std::uint64_t of_w = at.errors[0][k] + at.errors[1][k];
        at.errors[of_vertex][k] = of_point;
        at.errors[of_face][k] = of_point + of_w;
    }
}

bool is_in_triangle(const ClosestOnSegments& at) noexcept {
    return at.parameter_max[0] + at.parameter_max[1] < 1 - 4 * two_u;
}

}  // namespace

std::optional<FixedClosest> FixedClosest::of_features(const std::array<PosedFeature, 2>& features, const Radii& radii,
                                                      Names names, Foot foot) noexcept {
    const std::array<std::size_t, 2> counts{features[0].count, features[1].count};
    const FeatureKind kind = features_of_counts(counts[0], counts[1]).kind;
    names.kind = static_cast<ClosestKind>(kind);
    const int high = std::max(exponent_above(radii.a), exponent_above(radii.b));
    const SegmentEnds ends = ends_of(features, high);
    std::optional<ClosestOnSegments> at = closest_on_segments(ends);
    if (!at || !at->is_only) return std::nullopt;
    const bool has_face = kind == FeatureKind::vertex_face;
    for (const std::size_t side : {0, 1}) {
        if (at->features.corner_count(side) != (has_face ? 2 : counts[side])) return std::nullopt;
    }
    const std::optional<FixedVector> w = at->between();
    if (!w || (has_face && foot == Foot::in_triangle && !is_in_triangle(*at))) return std::nullopt;
    if (has_face) move_to_features(*at, ends, counts[0] == 3 ? 0 : 1);
    return FixedClosest(*at, *w, ends.unit, radii, names);
}

FixedClosest FixedClosest::inverted() const noexcept {
    FixedClosest result = *this;
    result.is_inverted_ = true;
    return result;
}

// All three numbers are below 2^(unit + 123).
FixedClosest::Gap FixedClosest::gap() const noexcept {
    const int high = std::max({unit_ + w_.width(), exponent_above(radii_.a), exponent_above(radii_.b)});
    const int unit = high - 123;
    const FixedNumber length = w_.length(unit_ - unit);
    const FixedNumber sum = fixed_number(radii_.a, unit) + fixed_number(radii_.b, unit);
    return {is_inverted_ ? length + sum : length - sum, unit};
}

std::optional<double> FixedClosest::signed_distance() const noexcept {
    const auto [number, unit] = gap();
    return number.rounded_distance(unit);
}

std::optional<DistanceBounds> FixedClosest::distance_bounds() const noexcept {
    const std::optional<double> rounded = signed_distance();
    if (!rounded || key_of(*rounded) == infinity_key) return std::nullopt;
    const double nearest = positive_part(*rounded);
    if (key_of(nearest) == 0) return DistanceBounds{0, 0};
    const auto [number, unit] = gap();
    const FixedNumber above = number - fixed_number(nearest, unit);
    if (above.value == 0 && above.error == 0) return DistanceBounds{nearest, nearest};
    if (size_of(above.value) <= above.error) return std::nullopt;
    return above.value < 0 ? DistanceBounds{next_down(nearest), nearest} : DistanceBounds{nearest, next_up(nearest)};
}

std::optional<ClosestPoints> FixedClosest::signed_closest() const noexcept {
    const std::optional<double> distance = signed_distance();
    if (!distance) return std::nullopt;
    ClosestPoints result;
    result.distance = *distance;
    result.kind = names_.kind;
    result.a = names_.a;
    result.b = names_.b;
    const FixedRadius of_a(radii_.a, unit_), of_b(radii_.b, unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber n = w_.direction(k), a = of_a.times(n), b = of_b.times(n), p = at_.number(0, k),
                          q = at_.number(1, k);
        const auto x = (is_inverted_ ? p - a : p + a).rounded(unit_);
        const auto y = (is_inverted_ ? q + b : q - b).rounded(unit_);
        if (!x || !y) return std::nullopt;
        result.point_a[static_cast<Eigen::Index>(k)] = *x;
        result.point_b[static_cast<Eigen::Index>(k)] = *y;
    }
    return result;
}

std::optional<Vec3> FixedClosest::direction() const noexcept {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<double> x = w_.direction(k).rounded(-FixedVector::unit_digits);
        if (!x) return std::nullopt;
        result[static_cast<Eigen::Index>(k)] = *x;
    }
    return result;
}

std::optional<Vec3> FixedClosest::middle() const noexcept {
    Vec3 result;
    const FixedRadius of_a(radii_.a, unit_), of_b(radii_.b, unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        const FixedNumber n = w_.direction(k);
        const auto sum = (at_.number(0, k) + of_a.times(n)) + (at_.number(1, k) - of_b.times(n));
        const std::optional<double> x = sum.rounded(unit_ - 1);
        if (!x) return std::nullopt;
        result[static_cast<Eigen::Index>(k)] = *x;
    }
    return result;
}

}  // namespace ecods::exact
