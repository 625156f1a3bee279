#include "query/body/rounded_segments.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "base/next.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/number/power.hpp"
#include "exact/point/segment_ends.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/segment_filter.hpp"

namespace ecods {
namespace {

exact::SegmentRef segment_of(const Posed<MeshShape>& core) noexcept {
    const Mesh& mesh = core.what->mesh();
    const Triangle& corners = mesh.triangles()[0];
    return {&core.pose, &mesh.vertices()[corners[0]], &mesh.vertices()[corners[1]]};
}

}  // namespace

std::optional<RoundedSegments> RoundedSegments::find(const CoreAndRadius& a, const CoreAndRadius& b) noexcept {
    std::optional<RoundedSegments> result;
    const bool has_radius = key_of(a.radius) != 0 || key_of(b.radius) != 0;
    const MeshShape &x = *a.core.what, &y = *b.core.what;
    if (!has_radius || !are_surfaces(x, y) || !is_segment(x) || !is_segment(y)) return result;
    const exact::Radii radii{a.radius, b.radius};
    const int high = std::max(exact::exponent_above(radii.a), exact::exponent_above(radii.b));
    const exact::SegmentEnds ends(segment_of(a.core), segment_of(b.core), high);
    const std::optional<exact::ClosestOnSegments> at = exact::closest_on_segments(ends);
    if (!at) return result;
    const std::optional<exact::FixedVector> w = at->between();
    if (!w) return result;
    Names names;
    exact::name_features(names, at->features, {0, 0});
    result.emplace(RoundedSegments(*at, *w, ends.unit, radii, names));
    return result;
}

// All three numbers are below 2^(unit + 123).
RoundedSegments::Gap RoundedSegments::gap() const noexcept {
    using exact::fixed_number;
    const int high = std::max({unit_ + w_.width(), exact::exponent_above(radii_.a), exact::exponent_above(radii_.b)});
    const int unit = high - 123;
    return {w_.length(unit_ - unit) - (fixed_number(radii_.a, unit) + fixed_number(radii_.b, unit)), unit};
}

std::optional<double> RoundedSegments::signed_distance() const noexcept {
    const auto [number, unit] = gap();
    const std::optional<double> rounded = number.rounded(unit);
    const bool is_lost = rounded && key_of(*rounded) == 0 && number.value != 0;
    return is_lost ? std::nullopt : rounded;
}

std::optional<DistanceBounds> RoundedSegments::distance_bounds() const noexcept {
    const std::optional<double> rounded = signed_distance();
    if (!rounded || key_of(*rounded) == infinity_key) return std::nullopt;
    const double nearest = positive_part(*rounded);
    if (key_of(nearest) == 0) return DistanceBounds{0, 0};
    const auto [number, unit] = gap();
    const exact::FixedNumber above = number - exact::fixed_number(nearest, unit);
    if (above.value == 0 && above.error == 0) return DistanceBounds{nearest, nearest};
    if (exact::size_of(above.value) <= above.error) return std::nullopt;
    return above.value < 0 ? DistanceBounds{next_down(nearest), nearest} : DistanceBounds{nearest, next_up(nearest)};
}

std::optional<ClosestPoints> RoundedSegments::signed_closest() const noexcept {
    const std::optional<double> distance = signed_distance();
    if (!distance) return std::nullopt;
    ClosestPoints result;
    result.distance = *distance;
    result.kind = names_.kind;
    result.a = names_.a;
    result.b = names_.b;
    const exact::FixedRadius of_a(radii_.a, unit_), of_b(radii_.b, unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        const exact::FixedNumber n = w_.direction(k);
        const auto x = (at_.number(0, k) + of_a.times(n)).rounded(unit_);
        const auto y = (at_.number(1, k) - of_b.times(n)).rounded(unit_);
        if (!x || !y) return std::nullopt;
        result.point_a[static_cast<Eigen::Index>(k)] = *x;
        result.point_b[static_cast<Eigen::Index>(k)] = *y;
    }
    return result;
}

std::optional<Vec3> RoundedSegments::direction() const noexcept {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<double> x = w_.direction(k).rounded(-exact::FixedVector::unit_digits);
        if (!x) return std::nullopt;
        result[static_cast<Eigen::Index>(k)] = *x;
    }
    return result;
}

std::optional<Vec3> RoundedSegments::middle() const noexcept {
    Vec3 result;
    const exact::FixedRadius of_a(radii_.a, unit_), of_b(radii_.b, unit_);
    for (std::size_t k = 0; k < 3; ++k) {
        const exact::FixedNumber n = w_.direction(k);
        const auto sum = (at_.number(0, k) + of_a.times(n)) + (at_.number(1, k) - of_b.times(n));
        const std::optional<double> x = sum.rounded(unit_ - 1);
        if (!x) return std::nullopt;
        result[static_cast<Eigen::Index>(k)] = *x;
    }
    return result;
}

}  // namespace ecods
