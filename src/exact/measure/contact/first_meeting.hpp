// first_meeting decides exactly the first time at which two moving triangles share a point.
//
// Let two closed triangles whose corners move on straight lines share no point at time 0, and let M be the set of times
// in [0, 1] at which they share one. M is closed, since the set of (time, point of one, point of the other) is compact;
// let s be its least element, so that s > 0. A triangle without area is the segment or the point that its corners span.
//
// 1. At s a corner of one and the other closed triangle, or a closed edge of each, share a point. Take an extreme point
// x of the intersection, which is convex. The relatively open features of the two that hold x meet in x alone. If one
// is a corner, or both are edges, we are done. Two faces do not meet in one point. An edge and a face cross each other:
// the ends are strictly on the two sides of the plane, and x strictly inside. They then cross at all times close to s,
// too, against the choice of s.
//
// 2. So s is the least of the first times of the 15 pairs of a corner and a triangle, or of two edges. Let P be such a
// pair of four corners, and v(t) its volume, a polynomial of degree 3 at most. P meets only where v is zero. If v is
// not zero throughout, the first time of P is the first root of v at which P meets.
//
// 3. If v is zero throughout, P is in one plane at all times (which moves). Let t > 0 be its first time. A corner
// strictly inside a triangle with area, or two edges that cross strictly inside of both, would have been so just before
// t, too. So, in an extreme point again, a corner is on a closed edge of the other side at t. For two edges this is a
// pair of a corner and a triangle, whose first time is no later; so two edges in one plane need no test. For a corner c
// and an edge pq of the triangle, t is a root of each coordinate of the turn (q - p) x (c - p). If these coordinates
// are not all zero throughout, any one that is not has t among its roots.
//
// 4. If they are all zero throughout, c, p and q are on one line at all times. If c were strictly between p and q at t,
// it would have been so just before. So c = p or c = q at t. If c = q, c is on the next edge, too, which begins at q,
// and 3 and 4 hold for that edge. So t is a root of each coordinate of c - p for an edge that begins at p, or a root
// that 3 finds. One of these coordinates is not zero throughout, or they would have met at time 0.
//
// The candidates are therefore the roots of at most 15 cubics, or, for cubics that vanish, of some quadratics and
// linear polynomials in their place; each candidate is tried on the pair that it comes from.
//
// All of this holds with any time up to which they share no point in place of 0. If only certain features may share a
// point in some time from there on, only the pairs of four corners that have such features are tried, and only for
// roots in that time.
#pragma once

#include <optional>

#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/measure/contact/possible_features.hpp"

namespace ecods::exact {

struct Meeting {
    double time;           // rounded once
    bool is_late;          // true if the exact time is above `time`
    FeaturePair features;  // the first, in the order of feature_pairs, that share a point then
};

// Returns nothing if the triangles share no point up to time 1. They must not share one at time 0.
std::optional<Meeting> first_meeting(MovingTriangles& triangles);

// The times from m / 2^bits to (m + count) / 2^bits, which is at most 1.
struct TimeCells {
    std::int64_t m;
    int bits, count;

    TimeSpan span() const noexcept;
};
// Returns cells that contain `time` and are at most four times as long, or 2^-43 of its end. Returns nothing if they
// would be longer than short_time, or `time` is very close to 0.
std::optional<TimeCells> cells_around(const TimeSpan& time) noexcept;

struct PartialAnswer {
    bool is_known;
    std::optional<Meeting> meeting;
};

// Finds the first meeting up to the end of the cells. The triangles must not share a point at the beginning of the
// cells or before, and in the cells only features of the set may. Not known if several candidates are in one cell.
PartialAnswer first_meeting_in(MovingTriangles& triangles, const TimeCells& cells, FeatureSet features);

}  // namespace ecods::exact
