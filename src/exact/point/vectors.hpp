// The functions of this file compute with vectors of doubles, in the order of operations that the error bounds assume,
// and with vectors of exact numbers.
#pragma once

#include <algorithm>
#include <cmath>

#include "exact/point/point.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

template <class Number>
concept IsCoordinate = requires(const Number& a) {
    a* a - a* a + a;
};

template <IsCoordinate Number>
ECODS_ALWAYS_INLINE Number dot(const std::array<Number, 3>& a,
                               const std::array<Number, 3>& b) noexcept(noexcept(a[0] * b[0])) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
template <IsCoordinate Number>
ECODS_ALWAYS_INLINE std::array<Number, 3> minus(const std::array<Number, 3>& a,
                                                const std::array<Number, 3>& b) noexcept(noexcept(a[0] - b[0])) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <IsCoordinate Number>
ECODS_ALWAYS_INLINE std::array<Number, 3> cross(const std::array<Number, 3>& a,
                                                const std::array<Number, 3>& b) noexcept(noexcept(a[0] * b[0])) {
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

ECODS_ALWAYS_INLINE double sum_of_magnitudes(const Point& a) noexcept {
    return (std::abs(a[0]) + std::abs(a[1])) + std::abs(a[2]);
}

// least_of() returns the index of the least of three numbers, greatest_of() of the greatest; of equal numbers the
// first.
ECODS_ALWAYS_INLINE std::size_t least_of(double x, double y, double z) noexcept {
    return x <= y ? (x <= z ? 0 : 2) : (y <= z ? 1 : 2);
}
ECODS_ALWAYS_INLINE std::size_t greatest_of(double x, double y, double z) noexcept {
    return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

// TriangleEdges holds the edges of two triangles: [t][i] is the vector from corner i of triangle t to the next corner.
using TriangleEdges = std::array<std::array<Point, 3>, 2>;
ECODS_ALWAYS_INLINE TriangleEdges edges_of(const Points<6>& x) noexcept {
    return {{{minus(x[1], x[0]), minus(x[2], x[1]), minus(x[0], x[2])},
             {minus(x[4], x[3]), minus(x[5], x[4]), minus(x[3], x[5])}}};
}

}  // namespace ecods::exact
