// The hot path: a pair of triangles decided by plain doubles and one bound.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/plain_signs.hpp"
#include "exact/triangle_pair.hpp"

namespace ecods::exact {

// The filter never certifies touching: a zero is beyond it.
enum class FilterAnswer { disjoint, crossing, unknown };

struct PlaneSides {
    double a, b, c;

    bool are_beyond(double bound) const noexcept {
        return (a > bound && b > bound && c > bound) || (a < -bound && b < -bound && c < -bound);
    }
    Sides signs() const noexcept { return {a > 0 ? 1 : -1, b > 0 ? 1 : -1, c > 0 ? 1 : -1}; }
};

inline PlaneSides plane_sides(const SixRounded& w, std::size_t own, std::size_t other) noexcept {
    const PlainNormal n = plain_normal(w[own], w[own + 1], w[own + 2]);
    return {plain_side(n, w[own], w[other]), plain_side(n, w[own], w[other + 1]), plain_side(n, w[own], w[other + 2])};
}

// `bound` is one for every determinant of these points. The comparisons are written so that a NaN leads to unknown.
inline FilterAnswer filter(const SixRounded& w, double bound) noexcept {
    const PlaneSides first = plane_sides(w, 3, 0);
    if (first.are_beyond(bound)) return FilterAnswer::disjoint;
    const PlaneSides second = plane_sides(w, 0, 3);
    if (second.are_beyond(bound)) return FilterAnswer::disjoint;
    // std::min may drop a NaN, so each value is compared.
    const bool sure = std::abs(first.a) > bound && std::abs(first.b) > bound && std::abs(first.c) > bound &&
                      std::abs(second.a) > bound && std::abs(second.b) > bound && std::abs(second.c) > bound;
    if (!sure) return FilterAnswer::unknown;

    const EdgeComparison e = name_corners(first.signs(), second.signs());
    const auto at = [&](int i) -> const Point& { return w[static_cast<std::size_t>(i)]; };
    const double begin = plain_orient3d(at(e.q1), at(e.p2), at(e.p1), at(e.q2));
    if (begin > bound) return FilterAnswer::disjoint;
    const double end = plain_orient3d(at(e.p1), at(e.p2), at(e.r1), at(e.r2));
    if (end > bound) return FilterAnswer::disjoint;
    return begin < -bound && end < -bound ? FilterAnswer::crossing : FilterAnswer::unknown;
}

}  // namespace ecods::exact
