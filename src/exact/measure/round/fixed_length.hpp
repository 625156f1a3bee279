// Lengths of vectors, and distances of points from lines, are computed from integers and rounded once. The functions
// return nullopt if the rounding is not certain, about once in 2^30 numbers; then fractions are rounded
// (squared_distance.hpp).
//
// If is_exact, points are exact; otherwise each coordinate of the difference of two points is off by less than 5 units.
// Coordinates are integers times 2^unit, and differences are below 2^123 in magnitude.
#pragma once

#include <optional>

#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// Returns the length of w, the difference of two points. A positive length is rounded to at least 2^-1074.
std::optional<double> fixed_length(const IntegerVector& w, int unit, bool is_exact) noexcept;

// Returns the distance of a point from a line. u is a vector along the line, from a point of the line, and w is the
// point relative to the same point. Returns nullopt also if the distance or u may be zero.
std::optional<double> fixed_distance_from_line(const IntegerVector& w, const IntegerVector& u, int unit,
                                               bool is_exact) noexcept;

}  // namespace ecods::exact
