// Vectors of doubles, in the order of operations that bounds are about.
#pragma once

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

}  // namespace ecods::exact
