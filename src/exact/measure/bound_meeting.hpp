// A lower bound of the first time at which two moving triangles share a point, in doubles, in any rounding mode.
//
// For a fixed vector n the gap
//     g(s) = min n . q - max n . p,     q and p the corners of the second and the first triangle at time s,
// is concave: each corner moves linearly, so min is the least of linear functions and max the largest. Between two
// times it is therefore nowhere below its chord. Where the gap is positive at both, the triangles are apart all the
// time; where it is only at one, they are from there to the chord's zero. The same holds for -n. So several n shorten
// an interval of time from both ends, and where they leave nothing, the triangles do not meet in it. An interval that
// they do not shorten by half is halved.
//
// Bound. A corner at time s is computed as P (1 - s) + Q s from its rounded places P and Q, which are off by `error`;
// so is the corner but for three factors (1 + e), |e| <= u' = 2^-52, on either product: 3.01 u' M, where M is the
// largest magnitude on the axis. Taking the reference point off before adds u' (|P| + |o|) to each of them, which is
// taken into `error`. A product with n meets three more factors on either term: 3.01 u' |n| M. The difference of two
// adds the bound twice, and u' times 2 |n| M. Together 2 error + 14.1 u' M on each axis, times |n|; 2.25 error + 20 u'
// M cover the bound's own rounding. Subtracting it adds u' of a number that is at most twice |n| M: covered, too.
// Underflow: coordinates are below 2^150, and n below 2^456. An operation that underflows, or a time that is taken for
// zero, loses 2^-1022 times such factors: below 2^-410. 2^-400 is added to the bound.
#pragma once

#include <optional>

#include "exact/point/point.hpp"

namespace ecods::exact {

// The corners of both triangles at the times 0 and 1, rounded, and how far they are off on any axis.
struct MovingPoints {
    Points<6> start, end;
    double error;
};

// A time in [from, to] before which the triangles share no point from `from` on; nothing if they share none up to `to`.
// 0 <= from <= to <= 1.
std::optional<double> bound_first_meeting(const MovingPoints& points, double from, double to) noexcept;

}  // namespace ecods::exact
