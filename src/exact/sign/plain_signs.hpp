// PlainSigns computes determinants in doubles and returns their signs without a test of the rounding error.
//
// The filter's bounds are derived for these functions: they have the order of operations that the proofs assume.
#pragma once

#include <array>

#include "exact/point/point.hpp"
#include "exact/sign/exact_signs.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

using PlainNormal = std::array<double, 3>;

// Returns (b - a) x (d - c), rounded.
ECODS_ALWAYS_INLINE PlainNormal plain_cross(const Point& a, const Point& b, const Point& c, const Point& d) noexcept {
    const double x1 = b[0] - a[0], y1 = b[1] - a[1], z1 = b[2] - a[2];
    const double x2 = d[0] - c[0], y2 = d[1] - c[1], z2 = d[2] - c[2];
    return {y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2};
}

ECODS_ALWAYS_INLINE PlainNormal plain_normal(const Point& a, const Point& b, const Point& c) noexcept {
    return plain_cross(a, b, a, c);
}

ECODS_ALWAYS_INLINE double plain_side(const PlainNormal& n, const Point& a, const Point& p) noexcept {
    return (n[0] * (p[0] - a[0]) + n[1] * (p[1] - a[1])) + n[2] * (p[2] - a[2]);
}

// Returns det(b - a, c - a, d - a), rounded.
inline double plain_orient3d(const Point& a, const Point& b, const Point& c, const Point& d) noexcept {
    return plain_side(plain_normal(a, b, c), a, d);
}

inline double plain_orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
}

inline int sign_of(double x) noexcept {
    return (x > 0) - (x < 0);
}

// Returns the sign, 1 or -1, if |x| > bound; otherwise, or if x is NaN, returns 0.
inline int certain_sign(double x, double bound) noexcept {
    return (x > bound) - (x < -bound);
}

// PlainArithmetic is an integer kernel (exact/number/kernel.hpp) that computes in doubles. Determinants of the points
// must have no rounding errors.
struct PlainArithmetic {
    using Point = exact::Point;
    using Normal = PlainNormal;

    static Normal normal(const Point& a, const Point& b, const Point& c) noexcept { return plain_normal(a, b, c); }
    static int side(const Normal& normal, const Point& a, const Point& p) noexcept {
        return sign_of(plain_side(normal, a, p));
    }
    static int orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
        return sign_of(plain_orient2d(a, b, c, axis));
    }
    static int compare(const Point& a, const Point& b, int axis) noexcept {
        const auto k = static_cast<std::size_t>(axis);
        return (a[k] > b[k]) - (a[k] < b[k]);
    }
    static bool is_zero(double minor) noexcept { return minor == 0; }
};

template <std::size_t N>
class PlainSigns : public ExactSigns<PlainArithmetic, N> {
  public:
    explicit PlainSigns(const Points<N>& points) noexcept : ExactSigns<PlainArithmetic, N>(points) {}
};

}  // namespace ecods::exact
