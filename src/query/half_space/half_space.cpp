// Defines the shape HalfSpace, its box, and its hits.
#include "ecods/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hash.hpp"
#include "base/make_error.hpp"
#include "base/next.hpp"
#include "exact/measure/round/fraction.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/starts_inside.hpp"
#include "query/half_space/heights.hpp"
#include "query/half_space/lowest.hpp"
#include "query/half_space/round.hpp"

namespace ecods {
namespace {

using exact::ScaledInteger;
using half_spaces::Plane;
using half_spaces::Quotient;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_zero(double x) noexcept {
    return coordinate_bits(x) == 0;
}

// A LineAsked is a segment or a ray: the points begin + s step for parameters s from 0 to `last`.
struct LineAsked {
    explicit LineAsked(const Segment& segment)
        : begin(segment.a), end(segment.b), is_direction(false), is_point(same_point(segment.a, segment.b)), last(1) {}
    explicit LineAsked(const Ray& ray)
        : begin(ray.origin),
          end(ray.direction),
          is_direction(true),
          is_point(is_zero(ray.max_parameter)),
          last(ray.max_parameter) {}

    ScaledInteger rise(const Plane& plane) const {
        return is_direction ? plane.along(end) : plane.along(end) - plane.along(begin);
    }
    // Sets `parameter` to s and `point` to the point at s, each rounded to the nearest double.
    void place(const exact::FractionRef& s, double& parameter, Vec3& point) const {
        const exact::RoundedOnLine rounded = exact::round_on_line(begin, end, is_direction, s);
        parameter = rounded.parameter;
        point = rounded.point;
    }
    // Sets `parameter` and `point` to those of the line's last point, which is at infinity if the ray has no end.
    void place_last(double& parameter, Vec3& point) const {
        if (last < infinity) return place(exact::fraction_of(last).ref(), parameter, point);
        parameter = infinity;
        for (int k = 0; k < 3; ++k) {
            const double from = is_zero(begin[k]) ? 0.0 : begin[k];
            point[k] = is_zero(end[k]) ? from : std::signbit(end[k]) ? -infinity : infinity;
        }
    }

    Vec3 begin, end;  // `end` is the direction if is_direction, otherwise a point
    bool is_direction, is_point;
    double last;  // the largest parameter
};

// Returns the hit of a line that lies in the plane.
Hit hit_along(const LineAsked& line) {
    Hit hit;
    hit.kind = line.is_point ? HitKind::face : HitKind::along;
    line.place(exact::fraction_of(0).ref(), hit.parameter, hit.point);
    hit.leave_point = hit.point;
    hit.feature = half_spaces::plane_feature;
    if (!line.is_point) line.place_last(hit.leave_parameter, hit.leave_point);
    return hit;
}

std::vector<Hit> find_hits(const LineAsked& line, const Posed<HalfSpace>& posed) {
    const Plane plane(posed, 0);
    const ScaledInteger height = plane.height(line.begin), rise = line.rise(plane);
    std::vector<Hit> hits;
    if (height.sign() < 0) hits.push_back(hit_inside(line.begin));
    if (rise.sign() == 0) {
        if (height.sign() == 0) hits.push_back(hit_along(line));
        return hits;
    }
    if (height.sign() * rise.sign() > 0) return hits;
    const Quotient at(-height, rise);
    if (exact::compare(at.ref(), line.last) > 0) return hits;
    Hit hit;
    hit.kind = rise.sign() < 0 ? HitKind::front : HitKind::back;
    hit.rank = static_cast<std::uint32_t>(hits.size());
    line.place(at.ref(), hit.parameter, hit.point);
    hit.feature = half_spaces::plane_feature;
    hit.leave_parameter = hit.parameter;
    hit.leave_point = hit.point;
    hits.push_back(hit);
    return hits;
}

}  // namespace

HalfSpace::HalfSpace(const Vec3& normal, double offset) : normal_(normal), offset_(offset) {
    for (int k = 0; k < 3; ++k) {
        if (!is_finite(normal[k])) throw invalid_normal(k, normal[k]);
    }
    if (same_point(normal, Vec3::Zero())) throw no_normal();
    if (!is_finite(offset)) throw invalid_offset(offset);
}

Aabb HalfSpace::box(const Pose& pose) const {
    const Plane plane(Posed<HalfSpace>(*this, pose), 0);
    Aabb box{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
    const auto& N = plane.exact().N;
    const auto is_not_zero = [](const ScaledInteger& x) { return x.sign() != 0; };
    if (std::ranges::count_if(N, is_not_zero) > 1) return box;
    // The half space ends on the axis of the only coordinate N_k of N that is not zero, at x with N_k x = E + N . t.
    const auto found = std::ranges::find_if(N, is_not_zero);
    const ScaledInteger& n = *found;
    const auto axis = found - N.begin();
    const ScaledInteger end_times_n = plane.exact().E + plane.along(pose.t);
    const bool is_above = n.sign() > 0;
    double end = half_spaces::round_quotient(end_times_n, n);
    const bool is_exact = is_finite(end) && compare(ScaledInteger(end) * n, end_times_n) == 0;
    if (!is_exact) end = is_above ? next_up(end) : next_down(end);
    (is_above ? box.max : box.min)[axis] = end;
    return box;
}

std::uint64_t HalfSpace::digest() const noexcept {
    std::uint64_t digest = combine(0, ShapeKind::half_space().value);
    for (const double x : {normal_[0], normal_[1], normal_[2], offset_}) digest = combine(digest, coordinate_bits(x));
    return digest;
}

std::vector<Hit> HalfSpace::all_hits(const Segment& segment, const Pose& pose, const Ask& /*ask*/) const {
    validate(segment);
    return find_hits(LineAsked(segment), {*this, pose});
}

std::vector<Hit> HalfSpace::all_hits(const Ray& ray, const Pose& pose, const Ask& /*ask*/) const {
    validate(ray);
    return find_hits(LineAsked(ray), {*this, pose});
}

}  // namespace ecods
