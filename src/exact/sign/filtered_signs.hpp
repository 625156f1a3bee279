// Signs from the filter where its bound allows, else from an integer kernel, for the decision in triangle_pair.hpp.
#pragma once

#include <array>

#include "exact/sign/filter.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/kernel_signs.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Bounds for the determinants of one pair of triangles.
struct PairBound {
    double orient3d;
    std::array<double, 3> orient2d;  // by the axis of projection
};

inline PairBound pair_bound(const SixRounded& points, double delta) noexcept {
    std::array<double, 3> extent;
    for (std::size_t k = 0; k < 3; ++k) {
        double min = points[0][k], max = points[0][k];
        for (std::size_t i = 1; i < 6; ++i) {
            min = std::min(min, points[i][k]);
            max = std::max(max, points[i][k]);
        }
        extent[k] = max - min;
    }
    const DifferenceBound d = difference_bound(extent, delta);
    return {orient3d_bound(d), {orient2d_bound(d, 1, 2), orient2d_bound(d, 2, 0), orient2d_bound(d, 0, 1)}};
}

// The axis of the largest component of the rounded normal, where the filter works best, or -1 if that component may be
// zero.
inline int certain_normal_axis(const SixRounded& points, int triangle, const PairBound& bound) noexcept {
    const Point* const own = &points[static_cast<std::size_t>(3 * triangle)];
    const PlainNormal n = plain_normal(own[0], own[1], own[2]);
    const std::array<double, 3> size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const std::size_t largest = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    return size[largest] > bound.orient2d[largest] ? static_cast<int>(largest) : -1;
}

// Signs of single determinants, 0 where the filter leaves them open.
class FilterSigns {
  public:
    FilterSigns(const SixRounded& points, const PairBound& bound) noexcept : points_(points), bound_(bound) {}

    int orient3d(int a, int b, int c, int d) const noexcept {
        return certain_sign(plain_orient3d(at(a), at(b), at(c), at(d)), bound_.orient3d);
    }
    int orient2d(int a, int b, int c, int axis) const noexcept {
        return certain_sign(plain_orient2d(at(a), at(b), at(c), axis), bound_.orient2d[static_cast<std::size_t>(axis)]);
    }

  private:
    const Point& at(int point) const noexcept { return points_[static_cast<std::size_t>(point)]; }

    const SixRounded& points_;
    const PairBound& bound_;
};

template <class Kernel>
class FilteredSigns {
  public:
    // `trace`: the sides of planes, as the filter computed them.
    FilteredSigns(const SixRounded& points, const PairBound& bound, const FilterTrace& trace,
                  const Kernel& kernel) noexcept
        : points_(points), bound_(bound), trace_(trace), kernel_(kernel), filter_(points, bound), exact_(kernel) {}

    std::array<int, 3> sides(int triangle) const noexcept {
        const int own = 3 * triangle;
        const int other = 3 - own;
        Sides result = (triangle == 1 ? trace_.first : trace_.second).certain_signs(bound_.orient3d);
        if (result[0] != 0 && result[1] != 0 && result[2] != 0) return result;
        const auto normal = kernel_.normal(own, own + 1, own + 2);
        for (std::size_t i = 0; i < 3; ++i) {
            if (result[i] == 0) result[i] = kernel_.side(normal, own, other + static_cast<int>(i));
        }
        return result;
    }

    int orient3d(int a, int b, int c, int d) const noexcept {
        const int s = filter_.orient3d(a, b, c, d);
        return s != 0 ? s : exact_.orient3d(a, b, c, d);
    }
    int orient2d(int a, int b, int c, int axis) const noexcept {
        const int s = filter_.orient2d(a, b, c, axis);
        return s != 0 ? s : exact_.orient2d(a, b, c, axis);
    }
    int compare(int a, int b, int axis) const noexcept { return exact_.compare(a, b, axis); }

    int normal_axis(int triangle) const noexcept {
        const int axis = certain_normal_axis(points_, triangle, bound_);
        return axis >= 0 ? axis : exact_.normal_axis(triangle);
    }

  private:
    const SixRounded& points_;
    const PairBound& bound_;
    const FilterTrace& trace_;
    const Kernel& kernel_;
    FilterSigns filter_;
    KernelSigns<Kernel> exact_;
};

}  // namespace ecods::exact
