// FilteredSigns computes signs by the floating-point filter, and by an integer kernel if the filter's bound does not
// suffice.
#pragma once

#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Returns the axis on which the rounded normal of points plane, plane + 1 and plane + 2 is largest: a projection along
// this axis is best for the filter. Returns -1 if the normal may be zero on that axis.
template <std::size_t N>
int certain_normal_axis(const Points<N>& points, int plane, const DeterminantBounds& bounds) noexcept {
    ECODS_ASSERT(plane >= 0 && static_cast<std::size_t>(plane) + 2 < N);
    const Point* const own = &points[static_cast<std::size_t>(plane)];
    const PlainNormal n = plain_normal(own[0], own[1], own[2]);
    const std::array<double, 3> size{std::abs(n[0]), std::abs(n[1]), std::abs(n[2])};
    const std::size_t largest = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    return size[largest] > bounds.orient2d[largest] ? static_cast<int>(largest) : -1;
}

// FilterSigns computes signs of determinants of rounded points; a sign is 0 if the filter cannot decide it.
template <std::size_t N>
class FilterSigns {
  public:
    // The arguments must outlive this object.
    FilterSigns(const Points<N>& points, const DeterminantBounds& bounds) noexcept : points_(points), bounds_(bounds) {}

    Sides sides(int plane, int points) const noexcept {
        const PlainNormal n = plain_normal(at(plane), at(plane + 1), at(plane + 2));
        Sides result;
        for (int i = 0; i < 3; ++i) {
            const double side = plain_side(n, at(plane), at(points + i));
            result[static_cast<std::size_t>(i)] = certain_sign(side, bounds_.orient3d);
        }
        return result;
    }
    int orient3d(int a, int b, int c, int d) const noexcept {
        return certain_sign(plain_orient3d(at(a), at(b), at(c), at(d)), bounds_.orient3d);
    }
    int orient2d(int a, int b, int c, int axis) const noexcept {
        return certain_sign(plain_orient2d(at(a), at(b), at(c), axis),
                            bounds_.orient2d[static_cast<std::size_t>(axis)]);
    }
    int normal_axis(int plane) const noexcept { return certain_normal_axis(points_, plane, bounds_); }

  private:
    const Point& at(int i) const noexcept { return points_[static_cast<std::size_t>(i)]; }

    const Points<N>& points_;
    const DeterminantBounds& bounds_;
};

// FilteredSigns computes signs of determinants by the filter, and from the same points as integers if the filter cannot
// decide.
template <class Kernel, std::size_t N>
class FilteredSigns {
  public:
    // The arguments must outlive this object.
    FilteredSigns(const Points<N>& points, const DeterminantBounds& bounds,
                  const IntegerPoints<Kernel, N>& integers) noexcept
        : filter_(points, bounds), integers_(integers), exact_(integers) {}

    Sides sides(int plane, int points) const noexcept { return complete(filter_.sides(plane, points), plane, points); }
    int orient3d(int a, int b, int c, int d) const noexcept {
        const int s = filter_.orient3d(a, b, c, d);
        return s != 0 ? s : exact_.orient3d(a, b, c, d);
    }
    int orient2d(int a, int b, int c, int axis) const noexcept {
        const int s = filter_.orient2d(a, b, c, axis);
        return s != 0 ? s : exact_.orient2d(a, b, c, axis);
    }
    int compare(int a, int b, int axis) const noexcept { return exact_.compare(a, b, axis); }
    int normal_axis(int plane) const noexcept {
        const int axis = filter_.normal_axis(plane);
        return axis >= 0 ? axis : exact_.normal_axis(plane);
    }

    // Returns `sides` with each 0 replaced by the sign that integers give. `plane` and `points` are as in sides().
    Sides complete(Sides sides, int plane, int points) const noexcept {
        if (sides[0] != 0 && sides[1] != 0 && sides[2] != 0) return sides;
        const auto at = [&](int i) -> const auto& {
            return integers_.at[static_cast<std::size_t>(i)];
        };
        const auto normal = Kernel::normal(at(plane), at(plane + 1), at(plane + 2));
        for (int i = 0; i < 3; ++i) {
            int& side = sides[static_cast<std::size_t>(i)];
            if (side == 0) side = Kernel::side(normal, at(plane), at(points + i));
        }
        return sides;
    }

  private:
    FilterSigns<N> filter_;
    const IntegerPoints<Kernel, N>& integers_;
    ExactSigns<Kernel, N> exact_;
};

}  // namespace ecods::exact
