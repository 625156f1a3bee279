// A matrix or vector is short if its digits fit into 64 bits. The matrices and vertices of all but a few percent of
// rotated models are short. The product of a short matrix and a short vector takes nine multiplications; a sum of
// general terms costs several times as much.
//
// Floating-point instructions are used to scale and convert numbers. The scaling and the conversions are exact in any
// rounding mode.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/number/power.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

// Short numbers are below 2^62 in magnitude, so a sum of three products is below 2^126.
inline constexpr int short_bits = 62;
// Numbers are scaled to short ones by a power of two whose exponent has at most this magnitude. Then no scaling
// underflows, in any rounding mode.
inline constexpr int short_power_max = 480;

// Sets `result` to x * power rounded towards zero, and returns true if x * power is an integer. x must be 0 or |x| >=
// 2^-500, and `power` a power of two with |x * power| < 2^62. The scaling is exact, so converting back gives the same
// number if and only if no digits were cut off.
inline bool to_short(double x, double power, std::int64_t& result) noexcept {
    const double scaled = x * power;
    result = static_cast<std::int64_t>(scaled);
    return static_cast<double>(result) == scaled;
}

class ShortMatrix {
  public:
    // Binds R and returns true if its digits fit. The functions below may be called only if bind() returned true.
    bool bind(const Mat3& R) noexcept;

    // The entries are integers in units of 2^unit(); times(x) returns the matrix times x in that unit.
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

// ShortProducts computes products R v for the vertices v of a mesh: from short numbers if R and all vertices are short,
// otherwise as sums of general terms.
class ShortProducts {
  public:
    // Binds R. `v` are the digits of the vertices' coordinates, and `products` the digits of all products R_ij v_j.
    void bind(const Mat3& R, const std::array<BitRange, 3>& v, const BitRange& products) noexcept;
    void forget() noexcept { are_short_ = is_bound_ = false; }
    bool is_bound() const noexcept { return is_bound_; }

    // Adds R v, in units of 2^unit, to p. `terms` must have the same R. Short products are exact: 2^unit must divide
    // all products, and these must be below 2^(unit + 120).
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
