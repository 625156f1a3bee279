// Determinants in plain double, and signs that take them at face value.
//
// The functions are what the filter's bounds are about: their order of operations is that of the proofs.
#pragma once

#include <array>

#include "simd/inline.hpp"

namespace ecods::exact {

using Point = std::array<double, 3>;
using SixRounded = std::array<Point, 6>;

struct PlainNormal {
    double x, y, z;
};

// (b - a) x (d - c)
ECODS_ALWAYS_INLINE PlainNormal plain_cross(const Point& a, const Point& b, const Point& c, const Point& d) noexcept {
    const double x1 = b[0] - a[0], y1 = b[1] - a[1], z1 = b[2] - a[2];
    const double x2 = d[0] - c[0], y2 = d[1] - c[1], z2 = d[2] - c[2];
    return {y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2};
}

ECODS_ALWAYS_INLINE PlainNormal plain_normal(const Point& a, const Point& b, const Point& c) noexcept {
    return plain_cross(a, b, a, c);
}

ECODS_ALWAYS_INLINE double plain_side(const PlainNormal& n, const Point& a, const Point& p) noexcept {
    return (n.x * (p[0] - a[0]) + n.y * (p[1] - a[1])) + n.z * (p[2] - a[2]);
}

// det(b - a, c - a, d - a)
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

// 1 or -1 if the sign is certain, else 0. A NaN is not certain.
inline int certain_sign(double x, double bound) noexcept {
    return (x > bound) - (x < -bound);
}

// Signs for triangle_pair.hpp that are right only where every operation is exact.
class PlainSigns {
  public:
    explicit PlainSigns(const SixRounded& points) noexcept : points_(points) {}

    std::array<int, 3> sides(int triangle) const noexcept {
        const int own = 3 * triangle;
        const int other = 3 - own;
        const PlainNormal n = plain_normal(at(own), at(own + 1), at(own + 2));
        return {sign_of(plain_side(n, at(own), at(other))), sign_of(plain_side(n, at(own), at(other + 1))),
                sign_of(plain_side(n, at(own), at(other + 2)))};
    }
    int orient3d(int a, int b, int c, int d) const noexcept {
        return sign_of(plain_orient3d(at(a), at(b), at(c), at(d)));
    }
    int orient2d(int a, int b, int c, int axis) const noexcept {
        return sign_of(plain_orient2d(at(a), at(b), at(c), axis));
    }
    int compare(int a, int b, int axis) const noexcept {
        const auto k = static_cast<std::size_t>(axis);
        return (at(a)[k] > at(b)[k]) - (at(a)[k] < at(b)[k]);
    }
    int normal_axis(int triangle) const noexcept {
        const int own = 3 * triangle;
        const PlainNormal n = plain_normal(at(own), at(own + 1), at(own + 2));
        return n.x != 0 ? 0 : n.y != 0 ? 1 : n.z != 0 ? 2 : -1;
    }

  private:
    const Point& at(int point) const noexcept { return points_[static_cast<std::size_t>(point)]; }

    const SixRounded& points_;
};

}  // namespace ecods::exact
