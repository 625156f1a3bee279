// Matrices and vectors are short if their digits fit into 64 bits, as they do for all but some percent of rotated
// models. The product of a short matrix and vector takes nine multiplications; terms of any digits cost several times
// that.
//
// Floating-point instructions scale and convert, exactly in any rounding mode.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/number/power.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

// Magnitudes of short numbers are below 2^62, so a sum of three products is below 2^126.
inline constexpr int short_bits = 62;
// Limits the exponents of powers of two by which numbers are scaled to short ones, so that no scaling underflows, in
// any mode.
inline constexpr int short_power_max = 480;

// Converts x * power, for |x| >= 2^-500 or x = 0 and a power of two that leaves |x * power| below 2^62. Returns true if
// the product is an integer: scaling is exact, and converting back gives the same number if no digits were cut off.
inline bool to_short(double x, double power, std::int64_t& result) noexcept {
    const double scaled = x * power;
    result = static_cast<std::int64_t>(scaled);
    return static_cast<double>(result) == scaled;
}

class ShortMatrix {
  public:
    // Returns true if the digits fit; the functions below may be called only then.
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

// Computes products R v of the vertices of a mesh: short ones if R and all vertices are short, and sums of terms
// otherwise.
class ShortProducts {
  public:
    // Binds R. Coordinates of vertices have the digits `v`, and products R_ij v_j the digits `products`.
    void bind(const Mat3& R, const std::array<BitRange, 3>& v, const BitRange& products) noexcept;
    void forget() noexcept { are_short_ = is_bound_ = false; }
    bool is_bound() const noexcept { return is_bound_; }

    // Adds R v in units of 2^unit; `terms` are the terms of the same R. Short products are exact: 2^unit must divide
    // all of them, and they must be below 2^(unit + 120).
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
