// A FixedVector is a vector between two points in fixed precision. It has the length and the unit vector as numbers
// with error bounds, from which the distances and closest points of rounded points and segments are rounded.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "exact/measure/round/fixed_digits.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// A FixedNumber is the interval value +- error, in units that its user defines.
struct FixedNumber {
    Int128 value = 0;
    Uint128 error = 0;

    friend FixedNumber operator+(const FixedNumber& x, const FixedNumber& y) noexcept {
        return {x.value + y.value, x.error + y.error};
    }
    friend FixedNumber operator-(const FixedNumber& x, const FixedNumber& y) noexcept {
        return {x.value - y.value, x.error + y.error};
    }

    // Returns the double nearest to all numbers of the interval, in units of 2^unit; a zero is +0. Returns nullopt if
    // the numbers do not all round to one double, or only some of them are zero.
    std::optional<double> rounded(int unit) const noexcept;
    // Returns rounded(unit), but nullopt if a number that is not 0 is rounded to 0.
    std::optional<double> rounded_distance(int unit) const noexcept;
};

// Returns x in units of 2^unit, rounded down. |x| must be below 2^(unit + 126).
FixedNumber fixed_number(double x, int unit) noexcept;

// ErrorBounds are upper bounds of the errors of three coordinates, below 2^62. A coordinate with the bound 0 is exact.
using ErrorBounds = std::array<std::uint64_t, 3>;

class FixedVector {
  public:
    // Returns w as a FixedVector; nullopt if w may be zero, or is so short that the error of its direction is too
    // large. The coordinates of w are integers below 2^123, in any unit.
    static std::optional<FixedVector> of(const IntegerVector& w, const ErrorBounds& errors) noexcept;

    // Returns an exponent such that |w| < 2^width().
    int width() const noexcept { return 127 - up_; }

    // Returns |w| 2^d. width() + d must be at most 124.
    FixedNumber length(int d) const noexcept;

    // Returns coordinate k of w / |w| in units of 2^-unit_digits.
    static constexpr int unit_digits = 126;
    FixedNumber direction(std::size_t k) const noexcept;

  private:
    FixedVector() = default;
    bool is_zero(std::size_t k) const noexcept { return x_[k] == 0 && errors_[k] == 0; }
    std::uint64_t largest_error() const noexcept { return std::max({errors_[0], errors_[1], errors_[2]}); }

    IntegerVector x_{};  // w 2^up_; the largest coordinate has 126 digits
    int up_ = 0;
    ErrorBounds errors_{};
    Uint128 error_ = 0;  // of the coordinates of x_
    int axis_ = -1;      // the axis along which w is, if that is certain; otherwise -1
    Int256 square_{};
    Uint128 root_ = 0;  // 2^252 / |x_|, with a relative error of at most 2^-94
};

// FixedRadius multiplies directions by a radius r >= 0; products are in units of 2^unit. r must be below 2^(unit +
// 120).
class FixedRadius {
  public:
    FixedRadius(double r, int unit) noexcept;

    // Returns r n, for n in units of 2^-unit_digits.
    FixedNumber times(const FixedNumber& n) const noexcept;

  private:
    FixedNumber whole_;   // r
    std::int64_t m_ = 0;  // r is m_ 2^(unit + unit_digits - shift_), and m_ has 62 digits, or is 0
    int shift_ = 0;
};

}  // namespace ecods::exact
