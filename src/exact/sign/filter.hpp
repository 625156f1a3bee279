// The hot path: a pair of triangles decided by plain doubles and one bound.
//
// A bound is either finite, and then no coordinate is large enough for a NaN or infinity to arise (filter_bound.hpp),
// or infinite, and then no comparison with it succeeds. So minima and maxima need no care about NaN.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/sign/plain_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// The filter never certifies touching: a zero is beyond it.
enum class FilterAnswer { disjoint, crossing, unknown };

// The values of one plane's determinant at three corners.
struct PlaneSides {
    double a, b, c;

    ECODS_ALWAYS_INLINE bool are_beyond(double bound) const noexcept {
        return std::min({a, b, c}) > bound || std::max({a, b, c}) < -bound;
    }
    ECODS_ALWAYS_INLINE bool are_certain(double bound) const noexcept {
        return std::min({std::abs(a), std::abs(b), std::abs(c)}) > bound;
    }
    // 1 or -1 where the sign is certain, else 0.
    ECODS_ALWAYS_INLINE Sides certain_signs(double bound) const noexcept {
        return {certain_sign(a, bound), certain_sign(b, bound), certain_sign(c, bound)};
    }
};

ECODS_ALWAYS_INLINE PlaneSides plane_sides(const SixRounded& w, std::size_t own, std::size_t other) noexcept {
    const PlainNormal n = plain_normal(w[own], w[own + 1], w[own + 2]);
    return {plain_side(n, w[own], w[other]), plain_side(n, w[own], w[other + 1]), plain_side(n, w[own], w[other + 2])};
}

// The two comparisons along the line of the planes, for sides that are all certain.
inline FilterAnswer filter_edges(const SixRounded& w, const Sides& first, const Sides& second, double bound) noexcept {
    const EdgeComparison e = name_corners(first, second);
    const auto at = [&](int i) -> const Point& { return w[static_cast<std::size_t>(i)]; };
    const double begin = plain_orient3d(at(e.q1), at(e.p2), at(e.p1), at(e.q2));
    if (begin > bound) return FilterAnswer::disjoint;
    const double end = plain_orient3d(at(e.p1), at(e.p2), at(e.r1), at(e.r2));
    if (end > bound) return FilterAnswer::disjoint;
    return begin < -bound && end < -bound ? FilterAnswer::crossing : FilterAnswer::unknown;
}

// What the filter found out before it gave up, for the stages after it.
struct FilterTrace {
    PlaneSides first;   // corners of the first triangle against the plane of the second
    PlaneSides second;  // set unless `first` decided
};

// `bound` is one for every determinant of these points.
ECODS_ALWAYS_INLINE FilterAnswer filter(const SixRounded& w, double bound, FilterTrace& trace) noexcept {
    trace.first = plane_sides(w, 3, 0);
    if (trace.first.are_beyond(bound)) return FilterAnswer::disjoint;
    trace.second = plane_sides(w, 0, 3);
    if (trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

// The same with another bound for determinants that are known.
inline FilterAnswer filter_again(const SixRounded& w, double bound, const FilterTrace& trace) noexcept {
    if (trace.first.are_beyond(bound) || trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

}  // namespace ecods::exact
