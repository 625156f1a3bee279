// bound_first_meeting() computes a lower bound of the first time at which two moving triangles share a point, in
// doubles and in any rounding mode.
//
// For a fixed vector n the gap
//     g(s) = min n . q - max n . p,     over the corners q of the second and p of the first triangle at time s,
// is concave: each corner moves linearly, so the minimum is concave and the maximum convex. Between two times the gap
// is therefore at least its chord. If the gap is positive at both times, the triangles are apart at all times between.
// If it is positive at only one of them, the triangles are apart from that time to the chord's zero. Gaps along -n are
// concave, too. So several vectors n shorten an interval of time from both ends; if nothing remains, the triangles do
// not meet in the interval. An interval that is not shortened by half is split in halves. moving_points.hpp derives the
// error bound that is subtracted from a gap.
//
// For a triangle that turns, the chord between two times is that of a straight motion which is near the turn
// (turning_points.hpp): a margin is subtracted from its gaps, and its times are bounded. The margin falls as the square
// of the interval's length.
#pragma once

#include <optional>

#include "exact/measure/contact/both_turning_points.hpp"
#include "exact/measure/contact/moving_points.hpp"
#include "exact/measure/contact/turn_and_straight_points.hpp"
#include "exact/measure/contact/turning_points.hpp"

namespace ecods::exact {

// bound_first_meeting() returns a part of [from, to], 0 <= from <= to <= 1, such that the triangles share no point in
// [from, to] before the part begins. In the part they may share points; nothing is known about the time after the part.
// Returns nullopt if the triangles share no point in [from, to].
//
// With coarse effort the part is usually longer, and begins earlier.
enum class Effort { coarse, fine };
std::optional<TimeSpan> bound_first_meeting(const MovingPoints& points, double from, double to, Effort effort) noexcept;
std::optional<TimeSpan> bound_first_meeting(const TurningPoints& points, double from, double to,
                                            Effort effort) noexcept;
std::optional<TimeSpan> bound_first_meeting(const BothTurningPoints& points, double from, double to,
                                            Effort effort) noexcept;
std::optional<TimeSpan> bound_first_meeting(const TurnAndStraightPoints& points, double from, double to,
                                            Effort effort) noexcept;

}  // namespace ecods::exact
