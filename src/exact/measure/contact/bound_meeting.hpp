// A lower bound of the first time at which two moving triangles share a point, in doubles, in any rounding mode.
//
// For a fixed vector n the gap
//     g(s) = min n . q - max n . p,     q and p the corners of the second and the first triangle at time s,
// is concave: each corner moves linearly, so min is the least of linear functions and max the largest. Between two
// times it is therefore nowhere below its chord. Where the gap is positive at both, the triangles are apart all the
// time; where it is only at one, they are from there to the chord's zero. The same holds for -n. So several n shorten
// an interval of time from both ends, and where they leave nothing, the triangles do not meet in it. An interval that
// they do not shorten by half is halved. moving_points.hpp has the bound that is taken off a gap.
#pragma once

#include <optional>

#include "exact/measure/contact/moving_points.hpp"

namespace ecods::exact {

// The first part of [from, to] in which the triangles may share a point: from `from` to its beginning they share none,
// and of what follows it nothing is said. Nothing if they share none up to `to`. 0 <= from <= to <= 1.
//
// With little effort that part is as a rule longer, and begins earlier.
enum class Effort { coarse, fine };
std::optional<TimeSpan> bound_first_meeting(const MovingPoints& points, double from, double to, Effort effort) noexcept;

}  // namespace ecods::exact
