// DifferenceSigns computes signs of determinants of N points. The points, and the differences of any two of them, must
// be exact in doubles.
//
// Each determinant then has its own error bound, computed from the magnitudes of its products, and is certainly zero if
// all products are zero. So axis-aligned bodies seldom need integers, however long their coordinates are.
//
// Bound. In any rounding mode fl(a op b) = (a op b)(1 + e), |e| <= u' = 2^-52. A determinant is a sum of six products
// of three differences. Each product has at most five factors 1 + e: two for multiplications, one for the difference in
// the minor, two for the sums. So the error is at most ((1 + u')^5 - 1) p, where p is the sum of the products'
// magnitudes. p is computed by the same operations on magnitudes, so it is too low by at most a factor of (1 - u')^5,
// and its product with 6 u' by another 1 - u'. Since ((1 + u')^5 - 1) (1 - u')^-6 < 5.0001 u', 6 u' p as computed is an
// error bound. The two products of a minor have two factors each, and ((1 + u')^2 - 1) (1 - u')^-3 < 2.0001 u', so 3 u'
// p is a bound for minors. Fused multiply-add removes factors; the bounds remain true.
//
// Range. Differences are multiples of 2^low below 2^(high + 3), with low >= -300 and high <= 200 (Frame, in
// exact/point/frame.cpp). So all products, rounded or not, are multiples of 2^(3 low) >= 2^-900 below 2^612. Nothing
// underflows or overflows, and p is zero only if every product is zero.
// Claim: verify/proofs/difference_signs.py
#pragma once

#include <array>
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Each permanent_...() function adds the magnitudes of the products that the function plain_...() of plain_signs.hpp
// adds and subtracts.
inline PlainNormal permanent_normal(const Point& a, const Point& b, const Point& c) noexcept {
    const double x1 = std::abs(b[0] - a[0]), y1 = std::abs(b[1] - a[1]), z1 = std::abs(b[2] - a[2]);
    const double x2 = std::abs(c[0] - a[0]), y2 = std::abs(c[1] - a[1]), z2 = std::abs(c[2] - a[2]);
    return {y1 * z2 + z1 * y2, z1 * x2 + x1 * z2, x1 * y2 + y1 * x2};
}

inline double permanent_side(const PlainNormal& n, const Point& a, const Point& p) noexcept {
    return (n[0] * std::abs(p[0] - a[0]) + n[1] * std::abs(p[1] - a[1])) + n[2] * std::abs(p[2] - a[2]);
}

inline double permanent_2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    return std::abs(b[i] - a[i]) * std::abs(c[j] - a[j]) + std::abs(b[j] - a[j]) * std::abs(c[i] - a[i]);
}

inline constexpr double determinant_error = 6 * two_u;  // factor of p, the sum of the products' magnitudes
inline constexpr double minor_error = 3 * two_u;

template <std::size_t N>
class DifferenceSigns {
  public:
    // Provides signs for `points`. `scale` is a power of two such that coordinates times scale are integers below 2^52.
    // The points must outlive this object.
    DifferenceSigns(const Points<N>& points, double scale) noexcept : points_(points), scale_(scale) {}

    // Returns the three signs of sides(), computed without branches, because a processor cannot predict which points
    // are in the plane.
    Sides sides(int plane, int points) noexcept {
        const PlainNormal n = plain_normal(at(plane), at(plane + 1), at(plane + 2));
        const PlainNormal m = permanent_normal(at(plane), at(plane + 1), at(plane + 2));
        Sides result;
        bool is_open = false;
        for (int i = 0; i < 3; ++i) {
            const double permanent = permanent_side(m, at(plane), at(points + i));
            const int s = certain_sign(plain_side(n, at(plane), at(points + i)), determinant_error * permanent);
            result[static_cast<std::size_t>(i)] = s;
            is_open |= (s == 0) & (permanent != 0);
        }
        return is_open ? integers().sides(plane, points) : result;
    }

    int orient3d(int a, int b, int c, int d) noexcept {
        const double permanent = permanent_side(permanent_normal(at(a), at(b), at(c)), at(a), at(d));
        const int s = certain_sign(plain_orient3d(at(a), at(b), at(c), at(d)), determinant_error * permanent);
        return s != 0 || permanent == 0 ? s : integers().orient3d(a, b, c, d);
    }

    int orient2d(int a, int b, int c, int axis) noexcept {
        const double permanent = permanent_2d(at(a), at(b), at(c), axis);
        const int s = certain_sign(plain_orient2d(at(a), at(b), at(c), axis), minor_error * permanent);
        return s != 0 || permanent == 0 ? s : integers().orient2d(a, b, c, axis);
    }

    int compare(int a, int b, int axis) const noexcept { return PlainArithmetic::compare(at(a), at(b), axis); }

    // Returns an axis on which the normal of points plane, plane + 1 and plane + 2 is not zero; -1 if the normal is
    // zero.
    int normal_axis(int plane) noexcept {
        const PlainNormal n = plain_normal(at(plane), at(plane + 1), at(plane + 2));
        const PlainNormal p = permanent_normal(at(plane), at(plane + 1), at(plane + 2));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (std::abs(n[axis]) > minor_error * p[axis]) return static_cast<int>(axis);
        }
        return p[0] == 0 && p[1] == 0 && p[2] == 0 ? -1 : integers().normal_axis(plane);
    }

    bool has_used_integers() const noexcept { return has_integers_; }

  private:
    const Point& at(int i) const noexcept { return points_[static_cast<std::size_t>(i)]; }

    // Returns a provider of exact signs from integers. The points are converted to integers on the first call.
    ExactSigns<OneLimbKernel, N> integers() noexcept {
        if (!has_integers_) {
            for (std::size_t i = 0; i < N; ++i) {
                for (std::size_t k = 0; k < 3; ++k) {
                    integers_.at[i][k] = static_cast<std::int64_t>(points_[i][k] * scale_);
                }
            }
            has_integers_ = true;
        }
        return ExactSigns(integers_);
    }

    const Points<N>& points_;
    double scale_;
    bool has_integers_ = false;
    IntegerPoints<OneLimbKernel, N> integers_;
};

}  // namespace ecods::exact
