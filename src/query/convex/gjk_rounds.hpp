// Runs the algorithm of Gilbert, Johnson and Keerthi (1988) in doubles, on any kind of hulls. All functions are inlined
// into code that is compiled for the instruction set in use (simd/dispatch.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "exact/point/vectors.hpp"
#include "simd/inline.hpp"

namespace ecods::convex {

// Simplex is a simplex of the Minkowski difference: pairs of vertices, one of each solid, and for each pair the point
// (second vertex) - (first vertex).
struct Simplex {
    int count = 0;
    std::array<std::array<std::uint32_t, 2>, 4> pairs{};
    std::array<exact::Point, 4> points{};
};

namespace gjk {

using exact::cross;
using exact::dot;
using exact::minus;
using exact::negated;
using exact::Point;
using exact::times;

// Limits the number of rounds. A search that ends by itself never needs so many rounds; the guess of any other search
// does not improve any more.
inline constexpr int rounds_max = 200;

// Nearest holds the simplex's point v that is nearest to the origin, its squared distance, and the vertices of which v
// is a combination.
struct Nearest {
    Point v{};
    double square = std::numeric_limits<double>::infinity();
    unsigned kept = 0;  // set of these vertices, as bits

    ECODS_ALWAYS_INLINE void take(const Point& point, unsigned bits) noexcept {
        const double s = dot(point, point);
        if (s < square) {
            v = point;
            square = s;
            kept = bits;
        }
    }
};

constexpr unsigned bit(int i) noexcept {
    return 1u << i;
}

ECODS_ALWAYS_INLINE void find_on_segment(const Simplex& s, int i, int j, Nearest& nearest) noexcept {
    const Point& a = s.points[static_cast<std::size_t>(i)];
    const Point& b = s.points[static_cast<std::size_t>(j)];
    const Point u = minus(b, a);
    const double t = -dot(a, u), uu = dot(u, u);
    if (t <= 0) return nearest.take(a, bit(i));
    if (t >= uu) return nearest.take(b, bit(j));
    nearest.take(minus(a, times(u, -t / uu)), bit(i) | bit(j));
}

// Offers to `nearest` the triangle's point nearest to the origin, found by the regions of the triangle (Ericson,
// Real-Time Collision Detection, 2005, 5.1.5).
ECODS_ALWAYS_INLINE void find_on_triangle(const Simplex& s, int i, int j, int k, Nearest& nearest) noexcept {
    const Point& a = s.points[static_cast<std::size_t>(i)];
    const Point& b = s.points[static_cast<std::size_t>(j)];
    const Point& c = s.points[static_cast<std::size_t>(k)];
    const Point u = minus(b, a), w = minus(c, a);
    const double d1 = -dot(u, a), d2 = -dot(w, a);
    if (d1 <= 0 && d2 <= 0) return nearest.take(a, bit(i));
    const double d3 = -dot(u, b), d4 = -dot(w, b);
    if (d3 >= 0 && d4 <= d3) return nearest.take(b, bit(j));
    const double d5 = -dot(u, c), d6 = -dot(w, c);
    if (d6 >= 0 && d5 <= d6) return nearest.take(c, bit(k));
    if (d1 >= 0 && d3 <= 0 && d1 * d4 - d3 * d2 <= 0) return find_on_segment(s, i, j, nearest);
    if (d2 >= 0 && d6 <= 0 && d5 * d2 - d1 * d6 <= 0) return find_on_segment(s, i, k, nearest);
    if (d4 - d3 >= 0 && d5 - d6 >= 0 && d3 * d6 - d5 * d4 <= 0) return find_on_segment(s, j, k, nearest);
    const Point n = cross(u, w);
    const double nn = dot(n, n);
    if (!(nn > 0)) {
        find_on_segment(s, i, j, nearest);
        find_on_segment(s, i, k, nearest);
        return find_on_segment(s, j, k, nearest);
    }
    nearest.take(times(n, dot(a, n) / nn), bit(i) | bit(j) | bit(k));
}

// Offers to `nearest` the nearest points of the faces that have, or may have, the origin on their outer side; if there
// is no such face, the origin is inside. The face without the last vertex needs no test: the nearest point was in this
// face, and the last vertex was added on the origin's side of it.
ECODS_ALWAYS_INLINE void find_in_tetrahedron(const Simplex& s, Nearest& nearest) noexcept {
    bool is_inside = true;
    for (int l = 2; l >= 0; --l) {
        const int i = l == 0 ? 1 : 0, j = l <= 1 ? 2 : 1, k = 3;
        const Point& a = s.points[static_cast<std::size_t>(i)];
        const Point n =
            cross(minus(s.points[static_cast<std::size_t>(j)], a), minus(s.points[static_cast<std::size_t>(k)], a));
        const double origin = -dot(n, a), other = dot(n, minus(s.points[static_cast<std::size_t>(l)], a));
        if ((origin > 0 && other > 0) || (origin < 0 && other < 0)) continue;
        is_inside = false;
        find_on_triangle(s, i, j, k, nearest);
    }
    if (is_inside) {
        nearest.square = 0;
        nearest.kept = 15;
    }
}

ECODS_ALWAYS_INLINE Nearest find_nearest(const Simplex& s) noexcept {
    Nearest nearest;
    if (s.count == 1) nearest.take(s.points[0], 1);
    if (s.count == 2) find_on_segment(s, 0, 1, nearest);
    if (s.count == 3) find_on_triangle(s, 0, 1, 2, nearest);
    if (s.count == 4) find_in_tetrahedron(s, nearest);
    return nearest;
}

ECODS_ALWAYS_INLINE void keep(Simplex& s, unsigned bits) noexcept {
    std::size_t count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i) {
        if ((bits >> i & 1) == 0) continue;
        s.pairs[count] = s.pairs[i];
        s.points[count] = s.points[i];
        ++count;
    }
    s.count = static_cast<int>(count);
}

ECODS_ALWAYS_INLINE bool has(const Simplex& s, const std::array<std::uint32_t, 2>& pair) noexcept {
    for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i) {
        if (s.pairs[i] == pair) return true;
    }
    return false;
}

template <class Hulls>
ECODS_ALWAYS_INLINE void add(Simplex& s, const Hulls& hulls, const std::array<std::uint32_t, 2>& pair) noexcept {
    const auto at = static_cast<std::size_t>(s.count++);
    s.pairs[at] = pair;
    s.points[at] = minus(hulls.rounded(1, pair[1]), hulls.rounded(0, pair[0]));
}

// Runs GJK, and leaves the result in `simplex`. hulls.rounded(side, vertex) must return a point; support(side,
// direction, start) a support vertex of a solid. Ends early if stop(simplex, nearest, pair) returns true, where `pair`
// has the support vertices along nearest.v.
template <class Hulls, class Support, class Stop>
ECODS_ALWAYS_INLINE void descend(Simplex& simplex, const Hulls& hulls, const Support& support,
                                 const Stop& stop) noexcept {
    Nearest nearest = find_nearest(simplex);
    keep(simplex, nearest.kept);
    if (simplex.count == 0) return;
    std::array<std::uint32_t, 2> at = simplex.pairs[0];
    for (int round = 0; round < rounds_max && simplex.count < 4 && nearest.square > 0; ++round) {
        at = {support(0, nearest.v, at[0]), support(1, negated(nearest.v), at[1])};
        if (stop(simplex, nearest, at) || has(simplex, at)) break;
        add(simplex, hulls, at);
        const Nearest found = find_nearest(simplex);
        if (!(found.square < nearest.square)) {
            --simplex.count;
            break;
        }
        nearest = found;
        keep(simplex, found.kept);
    }
}
template <class Hulls, class Support>
ECODS_ALWAYS_INLINE void descend(Simplex& simplex, const Hulls& hulls, const Support& support) noexcept {
    descend(simplex, hulls, support,
            [](const Simplex&, const Nearest&, const std::array<std::uint32_t, 2>&)
                ECODS_INLINE_LAMBDA { return false; });
}

}  // namespace gjk

}  // namespace ecods::convex
