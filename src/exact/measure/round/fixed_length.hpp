// The length of a vector and the distance of a point from a line, of integer points: rounded once wherever that is
// certain, which it is but for one in 2^30 or so. For what is left there are fractions (squared_distance.hpp).
//
// With `is_exact`, points are exact. Otherwise a coordinate of a difference of two of them is off by less than 5 units.
// Differences are below 2^123 in magnitude. A coordinate is a multiple of 2^unit.
#pragma once

#include <optional>

#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// Of a difference of two points, at least 2^-1074 if it is positive.
std::optional<double> fixed_length(const IntegerVector& w, int unit, bool is_exact) noexcept;

// The distance of a point from a line: it is w away from one end of the line's vector u. Nothing where it may be zero,
// or u may be.
std::optional<double> fixed_distance_from_line(const IntegerVector& w, const IntegerVector& u, int unit,
                                               bool is_exact) noexcept;

}  // namespace ecods::exact
