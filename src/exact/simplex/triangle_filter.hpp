// The triangle filter is the hot path: it decides in doubles, with one error bound, if two triangles share a point.
// Points 0 to 2 are the corners of the first triangle, 3 to 5 the corners of the second.
//
// A bound is finite or infinite. If it is finite, coordinates are so small that no NaN or infinity arises
// (exact/sign/filter_bound.hpp). If the bound is infinite, every comparison with it is false, so a NaN in std::min or
// std::max changes no answer.
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

// A FilterAnswer is a result of the filter. There is no answer "touching", since the filter cannot distinguish zero
// from a small number.
enum class FilterAnswer { disjoint, crossing, unknown };

// Returns the relation that follows from the answer; nullopt if the answer is unknown.
inline std::optional<Relation> certain_relation(FilterAnswer answer) noexcept {
    if (answer == FilterAnswer::unknown) return std::nullopt;
    return answer == FilterAnswer::disjoint ? Relation::apart : Relation::crossing;
}

// PlaneSides holds the determinants of one triangle's plane and each corner of the other triangle.
struct PlaneSides {
    double a, b, c;

    ECODS_ALWAYS_INLINE bool are_beyond(double bound) const noexcept {
        return std::min({a, b, c}) > bound || std::max({a, b, c}) < -bound;
    }
    ECODS_ALWAYS_INLINE bool are_certain(double bound) const noexcept {
        return std::min({std::abs(a), std::abs(b), std::abs(c)}) > bound;
    }
    // Returns for each corner 1 or -1 if the sign is certain, otherwise 0.
    ECODS_ALWAYS_INLINE Sides certain_signs(double bound) const noexcept {
        return {certain_sign(a, bound), certain_sign(b, bound), certain_sign(c, bound)};
    }
};

ECODS_ALWAYS_INLINE PlaneSides plane_sides(const Points<6>& w, std::size_t own, std::size_t other) noexcept {
    const PlainNormal n = plain_normal(w[own], w[own + 1], w[own + 2]);
    return {plain_side(n, w[own], w[other]), plain_side(n, w[own], w[other + 1]), plain_side(n, w[own], w[other + 2])};
}

// Returns the filter's answer from the triangles' intervals along the line of the two planes. All signs in `first` and
// `second` must be certain (1 or -1).
inline FilterAnswer filter_edges(const Points<6>& w, const Sides& first, const Sides& second, double bound) noexcept {
    const EdgeComparison e = name_corners(first, second);
    const auto at = [&](int i) -> const Point& { return w[static_cast<std::size_t>(i)]; };
    const double begin = plain_orient3d(at(e.q1), at(e.p2), at(e.p1), at(e.q2));
    if (begin > bound) return FilterAnswer::disjoint;
    const double end = plain_orient3d(at(e.p1), at(e.p2), at(e.r1), at(e.r2));
    if (end > bound) return FilterAnswer::disjoint;
    return begin < -bound && end < -bound ? FilterAnswer::crossing : FilterAnswer::unknown;
}

// A FilterTrace holds the determinants that the filter computed. If the filter's answer was unknown, later stages reuse
// these determinants.
struct FilterTrace {
    PlaneSides first;   // the first triangle's corners and the second's plane
    PlaneSides second;  // the reverse; not set if `first` sufficed for the answer
};

// Returns whether the triangles are disjoint or crossing, or `unknown`. `bound` must be an error bound of every
// orient3d of the six points. Sets `trace` to the determinants.
ECODS_ALWAYS_INLINE FilterAnswer filter(const Points<6>& w, double bound, FilterTrace& trace) noexcept {
    trace.first = plane_sides(w, 3, 0);
    if (trace.first.are_beyond(bound)) return FilterAnswer::disjoint;
    trace.second = plane_sides(w, 0, 3);
    if (trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

// Returns the answer of filter() for another bound, from the determinants in `trace`, whose `first` and `second` must
// be set.
inline FilterAnswer filter_again(const Points<6>& w, double bound, const FilterTrace& trace) noexcept {
    if (trace.first.are_beyond(bound) || trace.second.are_beyond(bound)) return FilterAnswer::disjoint;
    if (!trace.first.are_certain(bound) || !trace.second.are_certain(bound)) return FilterAnswer::unknown;
    return filter_edges(w, trace.first.certain_signs(bound), trace.second.certain_signs(bound), bound);
}

// TracedSigns is a FilteredSigns whose sides() are taken from a FilterTrace with `first` and `second` set. All other
// signs are computed as in FilteredSigns.
template <class Kernel>
class TracedSigns : public FilteredSigns<Kernel, 6> {
  public:
    // The arguments must outlive this object.
    TracedSigns(const Points<6>& points, const DeterminantBounds& bounds, const FilterTrace& trace,
                const IntegerPoints<Kernel, 6>& integers) noexcept
        : FilteredSigns<Kernel, 6>(points, bounds, integers), trace_(trace), bound_(bounds.orient3d) {}

    // The arguments must name the corners of one triangle and the plane of the other.
    Sides sides(int plane, int points) const noexcept {
        ECODS_ASSERT((plane == 0 && points == 3) || (plane == 3 && points == 0));
        return this->complete((plane == 3 ? trace_.first : trace_.second).certain_signs(bound_), plane, points);
    }

  private:
    const FilterTrace& trace_;
    double bound_;
};

}  // namespace ecods::exact
