// bound_first_meeting bounds the first time at which two moving triangles share a point from below, in doubles, in any
// rounding mode.
//
// For a fixed vector n the gap
//     g(s) = min n . q - max n . p,     q and p the corners of the second and the first triangle at time s,
// is concave: each corner moves linearly, so min is the least of linear functions and max the largest. Between two
// times the gap is therefore at least its chord. If the gap is positive at both times, the triangles are apart all the
// time between them; if it is positive at only one, they are apart from there to the chord's zero. Gaps along -n are
// concave, too. So several n shorten an interval of time from both ends, and if they leave nothing, the triangles do
// not meet in it. An interval that they do not shorten by half is halved. moving_points.hpp derives the error bound
// that is subtracted from a gap.
#pragma once

#include <optional>

#include "exact/measure/contact/moving_points.hpp"

namespace ecods::exact {

// Returns the first part of [from, to] in which the triangles may share a point. They share none from `from` to the
// beginning of that part; nothing is said about the time after it. Returns nothing if they share none up to `to`.
// 0 <= from <= to <= 1.
//
// With coarse effort the part is as a rule longer, and begins earlier.
enum class Effort { coarse, fine };
std::optional<TimeSpan> bound_first_meeting(const MovingPoints& points, double from, double to, Effort effort) noexcept;

}  // namespace ecods::exact
