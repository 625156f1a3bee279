#include "query/body/rounded_segments.hpp"

#include <algorithm>

#include "base/double_key.hpp"
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
    result.emplace(RoundedSegments(FixedClosest(*at, *w, ends.unit, radii, names)));
    return result;
}

}  // namespace ecods
