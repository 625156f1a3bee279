// Vectors of doubles, in the order of operations that bounds are about.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

ECODS_ALWAYS_INLINE double dot(const Point& a, const Point& b) noexcept {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
ECODS_ALWAYS_INLINE Point minus(const Point& a, const Point& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ECODS_ALWAYS_INLINE Point cross(const Point& a, const Point& b) noexcept {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
ECODS_ALWAYS_INLINE Point negated(const Point& a) noexcept {
    return {-a[0], -a[1], -a[2]};
}
ECODS_ALWAYS_INLINE Point times(const Point& a, double x) noexcept {
    return {a[0] * x, a[1] * x, a[2] * x};
}
ECODS_ALWAYS_INLINE double largest(const Point& a) noexcept {
    return std::max(std::max(std::abs(a[0]), std::abs(a[1])), std::abs(a[2]));
}

}  // namespace ecods::exact
