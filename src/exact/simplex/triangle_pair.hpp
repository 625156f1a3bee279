// triangle_pair decides from signs alone if two triangles are apart, touch or cross.
//
// The decision is written once, for any provider of signs (exact/sign/exact_signs.hpp); it is exact if the provider's
// signs are. Points 0 to 2 are the corners of the first triangle, 3 to 5 the corners of the second. A triangle is named
// by the index of its first corner.
//
// Triangles with areas in different planes (Guigue and Devillers 2003, derived again). Suppose that neither triangle
// has all corners strictly on one side of the other's plane. Then both triangles meet the line L of the two planes in
// closed intervals. Name the corners of the first triangle p1, q1, r1 such that p1 is alone on its side: q1 and r1 are
// on the opposite closed side. Name the second triangle's corners p2, q2, r2 likewise. Swap q2 and r2 if p1 is on the
// negative side of the second plane, and q1 and r1 if p2 is on the negative side of the first. Then, in one direction
// along L, the first interval goes from edge p1r1 to p1q1, and the second from p2q2 to p2r2. They share a point if and
// only if each begins before the other ends, or where it ends. Each of these two comparisons is the sign of orient3d of
// two edges: p2q2 and p1q1 for the second's begin and the first's end, p1r1 and p2r2 for the first's begin and the
// second's end. The intervals share an open interval if and only if both comparisons are strict.
//
// The triangles' relative interiors share a point if and only if each triangle has corners strictly on both sides of
// the other's plane (otherwise its interval on L is on its boundary) and both comparisons are strict.
#pragma once

#include <array>
#include <utility>

#include "base/assert.hpp"
#include "ecods/primitives.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/segment_pair.hpp"

namespace ecods::exact {

inline bool all_positive(const Sides& s) noexcept {
    return s[0] > 0 && s[1] > 0 && s[2] > 0;
}
inline bool all_negative(const Sides& s) noexcept {
    return s[0] < 0 && s[1] < 0 && s[2] < 0;
}
inline bool all_zero(const Sides& s) noexcept {
    return s[0] == 0 && s[1] == 0 && s[2] == 0;
}
inline bool strictly_on_both(const Sides& s) noexcept {
    return (s[0] > 0 || s[1] > 0 || s[2] > 0) && (s[0] < 0 || s[1] < 0 || s[2] < 0);
}

// An Apex is the corner that is alone on its side of a plane; `negative` is true if that side is the negative one.
struct Apex {
    int corner;
    bool negative;
};

// Returns the apex for the signs of three corners, which must not be all positive, all negative or all zero.
inline Apex find_apex(const Sides& s) noexcept {
    ECODS_ASSERT(!all_positive(s) && !all_negative(s) && !all_zero(s));
    const int positive_count = (s[0] > 0) + (s[1] > 0) + (s[2] > 0);
    const int negative_count = (s[0] < 0) + (s[1] < 0) + (s[2] < 0);
    // If exactly one corner is positive, the other two are on the closed negative side; if exactly one is negative, the
    // other two are on the closed positive side. Otherwise one corner is in the plane and the other two are strictly on
    // one side: the corner in the plane counts as being on the opposite side.
    const int wanted = positive_count == 1 ? 1 : negative_count == 1 ? -1 : 0;
    const bool negative = wanted < 0 || (wanted == 0 && positive_count > 0);
    return {s[0] == wanted ? 0 : s[1] == wanted ? 1 : 2, negative};
}

// An EdgeComparison names the corners p1, q1, r1, p2, q2, r2 of the derivation above, after the swaps there.
struct EdgeComparison {
    int p1, q1, r1, p2, q2, r2;
};

inline EdgeComparison name_corners(const Sides& first, const Sides& second) noexcept {
    const Apex a = find_apex(first);
    const Apex b = find_apex(second);
    EdgeComparison e{a.corner,     (a.corner + 1) % 3,     (a.corner + 2) % 3,
                     3 + b.corner, 3 + (b.corner + 1) % 3, 3 + (b.corner + 2) % 3};
    if (a.negative) std::swap(e.q2, e.r2);
    if (b.negative) std::swap(e.q1, e.r1);
    return e;
}

// Returns the relation of two triangles with areas in one plane, whose normal must not be zero on `axis`, along which
// the triangles are projected. Two convex polygons are disjoint if and only if all of one is strictly on the outer side
// of an edge of the other.
template <class Signs>
Relation coplanar_pair(Signs& signs, int axis) {
    for (const int own : {0, 3}) {
        const int other = 3 - own;
        const int turn = signs.orient2d(own, own + 1, own + 2, axis);
        ECODS_ASSERT(turn != 0);
        for (int edge = 0; edge < 3; ++edge) {
            const int from = own + edge;
            const int to = own + (edge + 1) % 3;
            bool outside = true;
            for (int corner = 0; corner < 3 && outside; ++corner) {
                outside = signs.orient2d(from, to, other + corner, axis) * turn < 0;
            }
            if (outside) return Relation::apart;
        }
    }
    return Relation::touching;
}

// Returns the relation of two triangles if all corners of one triangle are in the other's plane. (All points have side
// 0 to a triangle of zero area.)
template <class Signs>
Relation flat_pair(Signs& signs) {
    const int axis = signs.normal_axis(3);
    if (axis < 0 || signs.normal_axis(0) < 0) return degenerate_pair(signs);
    return coplanar_pair(signs, axis);
}

template <class Signs>
Relation triangle_pair(Signs& signs) {
    const Sides first = signs.sides(3, 0);
    if (all_positive(first) || all_negative(first)) return Relation::apart;
    if (all_zero(first)) return flat_pair(signs);
    const Sides second = signs.sides(0, 3);
    if (all_positive(second) || all_negative(second)) return Relation::apart;
    if (all_zero(second)) return flat_pair(signs);

    const EdgeComparison e = name_corners(first, second);
    const int begin = signs.orient3d(e.q1, e.p2, e.p1, e.q2);
    if (begin > 0) return Relation::apart;
    const int end = signs.orient3d(e.p1, e.p2, e.r1, e.r2);
    if (end > 0) return Relation::apart;
    const bool strict = begin < 0 && end < 0 && strictly_on_both(first) && strictly_on_both(second);
    return strict ? Relation::crossing : Relation::touching;
}

}  // namespace ecods::exact
