// ExactSigns computes signs of determinants of N points, of any bodies, in an arithmetic that makes no rounding errors
// with these points.
//
// A provider of signs, from this or another file of this folder, has these functions:
//
//     orient3d(a, b, c, d)     sign of det(b - a, c - a, d - a)
//     sides(plane, points)     orient3d(plane, plane + 1, plane + 2, p) for p = points, points + 1 and points + 2
//     orient2d(a, b, c, axis)  sign of the area of a, b, c in the projection along an axis: positive if they turn left
//     compare(a, b, axis)      sign of a - b on an axis
//     normal_axis(plane)       an axis on which the normal of points plane, plane + 1 and plane + 2 is not zero, or -1
//                              if they are on one line
//
// a, b, c, d, plane and points are indices of points. Decisions from signs are written once, for any provider.
#pragma once

#include <array>
#include <cstddef>

#include "base/assert.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

// Sides holds the signs of three points relative to one plane: the side on which each point is, or 0 if it is in the
// plane.
using Sides = std::array<int, 3>;

// Kernel is an integer kernel, or PlainArithmetic.
template <class Kernel, std::size_t N>
class ExactSigns {
  public:
    using Point = typename Kernel::Point;

    // The points must outlive this object.
    explicit ExactSigns(const std::array<Point, N>& points) noexcept : points_(points) {}
    explicit ExactSigns(const IntegerPoints<Kernel, N>& points) noexcept : points_(points.at) {}

    Sides sides(int plane, int points) const noexcept {
        const auto normal = normal_of(plane);
        return {Kernel::side(normal, at(plane), at(points)), Kernel::side(normal, at(plane), at(points + 1)),
                Kernel::side(normal, at(plane), at(points + 2))};
    }
    int orient3d(int a, int b, int c, int d) const noexcept {
        return Kernel::side(Kernel::normal(at(a), at(b), at(c)), at(a), at(d));
    }
    int orient2d(int a, int b, int c, int axis) const noexcept { return Kernel::orient2d(at(a), at(b), at(c), axis); }
    int compare(int a, int b, int axis) const noexcept { return Kernel::compare(at(a), at(b), axis); }

    int normal_axis(int plane) const noexcept {
        const auto normal = normal_of(plane);
        for (int axis = 0; axis < 3; ++axis) {
            if (!Kernel::is_zero(normal[static_cast<std::size_t>(axis)])) return axis;
        }
        return -1;
    }

  private:
    const Point& at(int i) const noexcept {
        ECODS_ASSERT(i >= 0 && static_cast<std::size_t>(i) < N);
        return points_[static_cast<std::size_t>(i)];
    }
    auto normal_of(int plane) const noexcept { return Kernel::normal(at(plane), at(plane + 1), at(plane + 2)); }

    const std::array<Point, N>& points_;
};

template <class Kernel, std::size_t N>
ExactSigns(const IntegerPoints<Kernel, N>&) -> ExactSigns<Kernel, N>;

}  // namespace ecods::exact
