// Limits that callers give are checked: distances and times.
#pragma once

#include <limits>

#include "base/double_key.hpp"
#include "ecods/error.hpp"

namespace ecods {

inline constexpr std::int64_t infinity_key = key_of(std::numeric_limits<double>::infinity());

// Throw InvalidDistance if d is negative or NaN; the second one also if d is infinite.
inline void require_distance(double d) {
    if (!is_from_zero(d)) throw InvalidDistance(d);
}
inline void require_finite_distance(double d) {
    if (!is_from_zero(d) || key_of(d) == infinity_key) throw InvalidDistance(d);
}

}  // namespace ecods
