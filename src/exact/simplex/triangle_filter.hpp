// The triangle filter is the hot path: it decides a pair of triangles by plain doubles and one bound. Points 0 to 2 are
// the corners of the first triangle, 3 to 5 the corners of the second.
//
// A bound is finite or infinite. If it is finite, no coordinate is large enough for a NaN or infinity to arise
// (exact/sign/filter_bound.hpp). If it is infinite, no comparison with it succeeds. So minima and maxima need no care
// about NaN.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "exact/point/point.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/sign/plain_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// The filter never certifies touching: it cannot distinguish a zero from a small number.
enum class FilterAnswer { disjoint, crossing, unknown };

// The relation that an answer is certain of.
inline std::optional<Relation> certain_relation(FilterAnswer answer) noexcept {
    if (answer == FilterAnswer::unknown) return std::nullopt;
    return answer == FilterAnswer::disjoint ? Relation::apart : Relation::crossing;
}

// Holds the values of one plane's determinant at three corners.
struct PlaneSides {
    double a, b, c;

    ECODS_ALWAYS_INLINE bool are_beyond(double bound) const noexcept {
        return std::min({a, b, c}) > bound || std::max({a, b, c}) < -bound;
    }
    ECODS_ALWAYS_INLINE bool are_certain(double bound) const noexcept {
        return std::min({std::abs(a), std::abs(b), std::abs(c)}) > bound;
    }
    // Returns 1 or -1 where the sign is certain, otherwise 0.
    ECODS_ALWAYS_INLINE Sides certain_signs(double bound) const noexcept {
        return {certain_sign(a, bound), certain_sign(b, bound), certain_sign(c, bound)};
    }
};

ECODS_ALWAYS_INLINE PlaneSides plane_sides(const Points<6>& w, std::size_t own, std::size_t other) noexcept {
    const PlainNormal n = plain_normal(w[own], w[own + 1], w[own + 2]);
    return {plain_side(n, w[own], w[other]), plain_side(n, w[own], w[other + 1]), plain_side(n, w[own], w[other + 2])};
}

// Decides by the two comparisons along the line of the planes, for sides that are all certain.
inline FilterAnswer filter_edges(const Points<6>& w, const Sides& first, const Sides& second, double bound) noexcept {
    const EdgeComparison e = name_corners(first, second);
    const auto at = [&](int i) -> const Point& { return w[static_cast<std::size_t>(i)]; };
    const double begin = plain_orient3d(at(e.q1), at(e.p2), at(e.p1), at(e.q2));
    if (begin > bound) return FilterAnswer::disjoint;
    const double end = plain_orient3d(at(e.p1), at(e.p2), at(e.r1), at(e.r2));
    if (end > bound) return FilterAnswer::disjoint;
    return begin < -bound && end < -bound ? FilterAnswer::crossing : FilterAnswer::unknown;
}

// Keeps the determinants that the filter computed before it gave up, for the stages after it.
struct FilterTrace {
    PlaneSides first;   // corners of the first triangle against the plane of the second
    PlaneSides second;  // set unless `first` decided
};

// Tries to decide by `bound`, which must hold for every orient3d of these points.
ECODS_ALWAYS_INLINE FilterAnswer filter(const Points<6>& w, double bound, FilterTrace& trace) noexcept {
    trace.first = plane_sides(w, 3, 0);
    if (trace.first.are_beyond(bound)) return FilterAnswer::disjoint;
    trace.second = plane_sides(w, 0, 3);
    if (trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

// Tries to decide by another bound, from determinants that have been computed.
inline FilterAnswer filter_again(const Points<6>& w, double bound, const FilterTrace& trace) noexcept {
    if (trace.first.are_beyond(bound) || trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

// Takes the sides of two triangles from a trace in which both planes are set, and other signs from FilteredSigns.
template <class Kernel>
class TracedSigns : public FilteredSigns<Kernel, 6> {
  public:
    // The arguments must outlive the signs.
    TracedSigns(const Points<6>& points, const DeterminantBounds& bounds, const FilterTrace& trace,
                const IntegerPoints<Kernel, 6>& integers) noexcept
        : FilteredSigns<Kernel, 6>(points, bounds, integers), trace_(trace), bound_(bounds.orient3d) {}

    // Two triangles have only these sides: `points` is the other triangle.
    Sides sides(int plane, int points) const noexcept {
        ECODS_ASSERT((plane == 0 && points == 3) || (plane == 3 && points == 0));
        return this->complete((plane == 3 ? trace_.first : trace_.second).certain_signs(bound_), plane, points);
    }

  private:
    const FilterTrace& trace_;
    double bound_;
};

}  // namespace ecods::exact
