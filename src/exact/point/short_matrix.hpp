// Matrices and vectors are short where their digits fit into 64 bits, as those of all but some percent of rotated
// models do. A product then is nine multiplications, where terms of any digits cost several times that.
//
// Floating-point instructions scale and convert, exactly in any mode.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/number/power.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

// Magnitudes of short numbers are below 2^62: a sum of three products is below 2^126.
inline constexpr int short_bits = 62;
// The exponents that powers may have by which numbers become short: no product of them underflows, in any mode.
inline constexpr int short_power_max = 480;

// Converts x times a power of two that leaves it below 2^62, for |x| >= 2^-500 or zero. Returns whether that is an
// integer: multiplied and converted exactly, and back without a rounding if no digits were cut off.
inline bool to_short(double x, double power, std::int64_t& result) noexcept {
    const double scaled = x * power;
    result = static_cast<std::int64_t>(scaled);
    return static_cast<double>(result) == scaled;
}

class ShortMatrix {
  public:
    // Returns whether the digits fit; only then may anything be asked.
    bool bind(const Mat3& R) noexcept;

    // Entries are integers in units of 2^unit().
    int unit() const noexcept { return unit_; }
    TwoLimbKernel::Point times(const std::array<std::int64_t, 3>& x) const noexcept {
        TwoLimbKernel::Point product;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& r = rows_[k];
            product[k] = (Int128{r[0]} * x[0] + Int128{r[1]} * x[1]) + Int128{r[2]} * x[2];
        }
        return product;
    }

  private:
    std::array<std::array<std::int64_t, 3>, 3> rows_{};
    int unit_ = 0;
};

// Products R v of the vertices of a mesh are short ones where R and all vertices are short, and sums of terms
// otherwise.
class ShortProducts {
  public:
    // Coordinates of vertices have the digits `v`, products the digits `products`.
    void bind(const Mat3& R, const std::array<BitRange, 3>& v, const BitRange& products) noexcept;
    void forget() noexcept { are_short_ = is_bound_ = false; }
    bool is_bound() const noexcept { return is_bound_; }

    // Adds R v, of which `terms` are the terms, in units of 2^unit. Short products are exact: the unit must divide all
    // of them, and 2^120 units be above them.
    void add(const PoseTerms& terms, const Vec3& v, int unit, TwoLimbKernel::Point& p) const noexcept {
        if (!are_short_) return terms.add_products(v, unit, p);
        std::array<std::int64_t, 3> x;
        for (std::size_t k = 0; k < 3; ++k) to_short(v[static_cast<Eigen::Index>(k)], power_of_v_, x[k]);
        const TwoLimbKernel::Point product = R_.times(x);
        const int shift = unit_ - unit;
        for (std::size_t k = 0; k < 3; ++k) p[k] += shift >= 0 ? product[k] << shift : product[k] >> -shift;
    }

  private:
    bool is_bound_ = false, are_short_ = false;
    ShortMatrix R_;
    double power_of_v_ = 1;
    int unit_ = 0;
};

}  // namespace ecods::exact
