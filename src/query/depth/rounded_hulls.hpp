// The vertices of two posed convex solids in doubles, with bounds of what they and sums of their products are off by.
//
// Points are counted from the first solid's translation (exact/point/point.hpp): a coordinate is off by delta, u' =
// 2^-52 bounds one operation. Let all coordinates be at most V, and those of differences m = p - q at most E. Then
//
//     m as computed                  e_m = 2 delta + u' E
//     an edge x = m1 - m0            e_x = 2 e_m + u' 2E           = 4 delta + 4 u' E
//     a coordinate of x * y          e_n = 17/4 u' X Y + 2 e_x (X + Y + e_x), where coordinates are at most X and Y
//     (two products of two roundings each, see exact/sign/filter_bound.hpp)
//     n . m, n off by e_n            e_h = 3 e_n E + |n| (2 delta + 4.1 u' E)
//     n . p less n . p', n as it is  e_p = 2 |n| (3.1 u' V + delta)
//     the same, n off by e_n         e_p + 6 E e_n,   as |p - p'| <= 2E: the differences extend as far as a solid does
//
// where |n| is the sum of the magnitudes of n's coordinates. A factor of 1 + 2^-20 covers terms of higher order and the
// roundings of the bounds themselves. Underflow loses less than 2^-1000 in all; as E is between 2^-200 and 2^200, and
// delta not above E, a bound of 2^-800 covers it. Scenes beyond are for integers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/arithmetic.hpp"
#include "query/convex/posed_hulls.hpp"
#include "simd/vec.hpp"

namespace ecods::depths {

using Double4 = Vec<double, 4>;
using Long4 = Vec<std::int64_t, 4>;

// What roundings are bounded by.
struct RoundedBounds {
    double delta = 0, V = 0, E = 0;
    double e_x = 0;

    double of_normal(double X, double Y) const noexcept {
        return slack * (4.25 * two_u * (X * Y) + 2 * e_x * ((X + Y) + e_x)) + 0x1p-800;
    }
    double of_height(double e_n, double n_sum) const noexcept {
        return slack * (3 * e_n * E + n_sum * (2 * delta + 4.1 * two_u * E));
    }
    double of_support(double n_sum) const noexcept { return slack * (2 * n_sum * (3.1 * two_u * V + delta)); }
    double of_level(double e_n, double n_sum) const noexcept { return of_support(n_sum) + slack * (6 * E * e_n); }

    static constexpr double slack = 1 + 0x1p-20;
};

class RoundedHulls {
  public:
    struct Side {
        std::vector<double> x, y, z;  // up to a multiple of four: the last vertex over again
        std::uint32_t count = 0;
        std::uint32_t padded_count() const noexcept { return (count + 3) & ~std::uint32_t{3}; }
    };

    // Returns whether bounds hold; nothing may be asked otherwise.
    bool bind(const convex::PosedHulls& hulls);

    // Whether the vertices of a solid are looked at as a whole: side() has them. Those of a larger one are posed when
    // they are asked for, and what is furthest is found by climbing, about.
    bool is_scanned(std::size_t i) const noexcept { return is_scanned_[i]; }
    const Side& side(std::size_t i) const noexcept { return sides_[i]; }
    const convex::PosedHulls& posed() const noexcept { return *posed_; }

    std::array<double, 3> point(std::size_t i, std::uint32_t v) const noexcept {
        const Side& of = sides_[i];
        if (is_scanned_[i]) return {of.x[v], of.y[v], of.z[v]};
        return posed_->rounded(i, v);
    }
    const RoundedBounds& bounds() const noexcept { return bounds_; }
    // From about the middle of the second solid to that of the first one: inside their set of differences, or near.
    const std::array<double, 3>& middle() const noexcept { return middle_; }

  private:
    struct Box {
        std::array<double, 3> low, high;
    };
    Box box_of_extremes(std::size_t i) const noexcept;

    const convex::PosedHulls* posed_ = nullptr;
    std::array<Side, 2> sides_;
    std::array<bool, 2> is_scanned_{};
    RoundedBounds bounds_;
    std::array<double, 3> middle_{};
};

struct Furthest {
    double along;
    std::uint32_t vertex;
};

// The vertex whose product with n is largest, or with sign -1 least, and that product.
template <int sign>
ECODS_ALWAYS_INLINE Furthest furthest(const RoundedHulls::Side& side, double nx, double ny, double nz) noexcept {
    const Double4 x = broadcast<Double4>(sign * nx), y = broadcast<Double4>(sign * ny),
                  z = broadcast<Double4>(sign * nz);
    Double4 best = load_anywhere<Double4>(side.x.data()) * x + load_anywhere<Double4>(side.y.data()) * y +
                   load_anywhere<Double4>(side.z.data()) * z;
    Long4 at{0, 1, 2, 3}, best_at = at;
    for (std::uint32_t i = 4; i < side.count; i += 4) {
        at += 4;
        const Double4 along = load_anywhere<Double4>(side.x.data() + i) * x +
                              load_anywhere<Double4>(side.y.data() + i) * y +
                              load_anywhere<Double4>(side.z.data() + i) * z;
        const auto is_further = along > best;
        best = select(is_further, along, best);
        best_at = select(is_further, at, best_at);
    }
    const Double4 other = shuffle<2, 3, 0, 1>(best);
    const Long4 other_at = shuffle<2, 3, 0, 1>(best_at);
    const auto is_further = other > best;
    best = select(is_further, other, best);
    best_at = select(is_further, other_at, best_at);
    const bool second = best[1] > best[0];
    const auto vertex = static_cast<std::uint32_t>(second ? best_at[1] : best_at[0]);
    return {sign * (second ? best[1] : best[0]), vertex < side.count ? vertex : side.count - 1};
}

}  // namespace ecods::depths
