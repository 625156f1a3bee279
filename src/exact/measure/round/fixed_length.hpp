// Lengths of vectors and distances of points from lines, of integer points, are rounded once if the rounding is
// certain, as it is but for one number in 2^30 or so. Fractions round the rest (squared_distance.hpp).
//
// If `is_exact`, points are exact. Otherwise a coordinate of a difference of two points is off by less than 5 units.
// Differences are below 2^123 in magnitude. A coordinate is a multiple of 2^unit.
#pragma once

#include <optional>

#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// Returns the length of w, a difference of two points: at least 2^-1074 if it is positive.
std::optional<double> fixed_length(const IntegerVector& w, int unit, bool is_exact) noexcept;

// Returns the distance of a point from a line: w is the point relative to one end of the line's vector u. Returns
// nothing if the distance or u may be zero.
std::optional<double> fixed_distance_from_line(const IntegerVector& w, const IntegerVector& u, int unit,
                                               bool is_exact) noexcept;

}  // namespace ecods::exact
