// first_meeting() computes exactly the first time at which two moving triangles share a point.
//
// Take two closed triangles whose corners move continuously and which share no point at time 0. Let M be the set of
// times in [0, 1] at which they share a point. M is closed, since the set of (time, point of one, point of the other)
// is compact. Let s > 0 be its least element. A triangle without area is the segment or the point that its corners
// span.
//
// 1. At time s a corner of one triangle is in the other closed triangle, or two closed edges share a point. For let x
// be an extreme point of the intersection, which is convex. The relatively open features of the two triangles that
// contain x have only x in common. If one of these is a corner, or both are edges, the claim holds. Two faces cannot
// have exactly one point in common. If they are an edge and a face, these cross: the edge's ends are strictly on the
// two sides of the plane, and x is strictly inside both. They then cross at all times close to s, too, which
// contradicts the choice of s.
//
// 2. So s is the least of the first times of 15 pairs: a corner and a triangle, or two edges. Let P be such a pair,
// with four corners, and v(t) the signed volume of their tetrahedron, a polynomial. P shares a point only at times at
// which v is zero. So, unless v is the zero polynomial, the first time of P is the first root of v at which P shares a
// point.
//
// 3. If v is the zero polynomial, P is in one (moving) plane at all times. Let t > 0 be the first time at which P
// shares a point. A corner strictly inside a triangle with area, or two edges that cross strictly inside of both, would
// have shared a point just before t, too. So, again for an extreme point, at t a corner is on a closed edge of the
// other triangle. If P has two edges, the corner and the other triangle are another pair, whose first time is no later;
// so two edges in one plane need no test. For a corner c and an edge pq of the triangle, t is a root of each coordinate
// of (q - p) x (c - p) ("turn"). If any coordinate is not the zero polynomial, t is among its roots.
//
// 4. If all three coordinates are the zero polynomial, c, p and q are on one line at all times. If c were strictly
// between p and q at t, it would have been so just before. So c = p or c = q at t. If c = q, c is on the next edge,
// too, which begins at q, and 3 and 4 hold for that edge. So t is a root of each coordinate of c - p for an edge that
// begins at p, or a root that 3 finds. At least one of these coordinates is not the zero polynomial, or c and p would
// have met at time 0.
//
// The candidates for s are therefore the roots of at most 15 polynomials, or, in place of one that is zero, of some
// other polynomials. At each candidate only the pair that it comes from is tested.
//
// All of this remains true if time 0 is replaced by any time up to which the triangles share no point. If only certain
// features may share a point in an interval that begins there, only pairs P that have such features are tried, and only
// for roots in that interval.
#pragma once

#include <optional>

#include "exact/measure/contact/possible_features.hpp"
#include "exact/measure/contact/relative_position.hpp"

namespace ecods::exact {

struct Meeting {
    double time;           // the exact time, rounded once
    bool is_late;          // true if the exact time is above `time`
    FeaturePair features;  // the first pair, in the order of feature_pairs, that shares a point at the exact time
};

// Returns the first meeting of the triangles in [0, 1]; nullopt if they do not meet. The triangles must not share a
// point at time 0.
template <class P>
std::optional<Meeting> first_meeting(RelativePositionOf<P>& triangles);

// TimeCells is the interval of time from m / 2^bits to (m + count) / 2^bits, which is at most 1.
struct TimeCells {
    std::int64_t m;
    int bits, count;

    TimeSpan span() const noexcept;
};
// Returns cells that contain `time`. The length of the cells is at most four times the length of `time`, or 2^-43 of
// the end of `time` if that is longer. Returns nullopt if the cells would be longer than short_time, or if `time` is
// very close to 0.
std::optional<TimeCells> cells_around(const TimeSpan& time) noexcept;

struct PartialAnswer {
    bool is_known;
    std::optional<Meeting> meeting;
};

// Returns the first meeting before the end of the cells; no meeting if the triangles do not meet before. The triangles
// must share no point up to the beginning of the cells, and in the cells only pairs of `features` may share points. If
// a cell contains several candidates, is_known is false in the result.
template <class P>
PartialAnswer first_meeting_in(RelativePositionOf<P>& triangles, const TimeCells& cells, FeatureSet features);

}  // namespace ecods::exact
