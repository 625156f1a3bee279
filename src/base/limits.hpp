// Distances and times that callers give as limits are checked here.
#pragma once

#include <limits>

#include "base/double_key.hpp"
#include "base/make_error.hpp"

namespace ecods {

inline constexpr std::int64_t infinity_key = key_of(std::numeric_limits<double>::infinity());

// Both functions throw InvalidArgument if d is negative or NaN. require_finite_distance also throws InvalidArgument if
// d is infinite.
inline void require_distance(double d) {
    if (!is_from_zero(d)) throw invalid_distance(d);
}
inline void require_finite_distance(double d) {
    if (!is_from_zero(d) || key_of(d) == infinity_key) throw invalid_distance(d);
}

// Returns min(max_time, 1), because every motion ends at time 1. Throws InvalidArgument if max_time is negative or NaN.
inline double require_time(double max_time) {
    if (!is_from_zero(max_time)) throw invalid_time(max_time);
    return key_of(max_time) < key_of(1.0) ? max_time : 1.0;
}

}  // namespace ecods
