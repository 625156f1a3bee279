// Limits that callers give are checked: distances and times.
#pragma once

#include <limits>

#include "base/double_key.hpp"
#include "base/make_error.hpp"

namespace ecods {

inline constexpr std::int64_t infinity_key = key_of(std::numeric_limits<double>::infinity());

// A limit is not negative and not NaN. Both throw InvalidArgument if d is none; the second one also if it is infinite.
inline void require_distance(double d) {
    if (!is_from_zero(d)) throw invalid_distance(d);
}
inline void require_finite_distance(double d) {
    if (!is_from_zero(d) || key_of(d) == infinity_key) throw invalid_distance(d);
}

// Throws InvalidArgument if a limit of time is negative or NaN. Returns it; motions end at 1.
inline double require_time(double max_time) {
    if (!is_from_zero(max_time)) throw invalid_time(max_time);
    return key_of(max_time) < key_of(1.0) ? max_time : 1.0;
}

}  // namespace ecods
