// An ExactSum is the exact sum of up to four doubles: radii, a clearance, and the distance in a question. With a
// rounded sum, balls that cross could be taken for balls that touch.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/next.hpp"
#include "exact/number/scaled_integer.hpp"

namespace ecods::exact {

class ExactSum {
  public:
    // Set the sum to 0, or to x, which must be finite.
    ExactSum() noexcept = default;
    ExactSum(double x);

    // Returns the sum plus x, or minus x. A sum has up to four terms that are not zero.
    ExactSum plus(double x) const;
    ExactSum minus(double x) const { return plus(-x); }
    ExactSum operator-() const;

    int sign() const noexcept { return sign_; }  // -1, 0 or 1
    // Returns the greatest double that is at most the sum, and the least double that is at least the sum. If the sum is
    // beyond the largest double, one of the two is infinite.
    double lower() const noexcept { return lower_; }
    double upper() const noexcept { return upper_; }
    bool is_double() const noexcept { return is_double_; }  // then lower() and upper() are the sum

    // Returns the sum. The sum of four doubles is a multiple of 2^-1074 below 2^1026, so it has at most 2100 bits.
    ScaledInteger scaled() const;

  private:
    void find_bounds();

    std::array<double, 4> terms_{};
    std::size_t count_ = 0;
    double lower_ = 0, upper_ = 0;
    int sign_ = 0;
    bool is_double_ = true;
};

// A Limit is an upper limit of distances: the sum itself is within the limit unless the limit is strict.
struct Limit {
    ExactSum sum;
    bool is_strict = false;

    // Returns the greatest double within the limit, which must not be zero. So a number up to that double is within the
    // limit, and a number of at least the next double is not.
    double greatest() const noexcept { return is_strict && sum.is_double() ? next_down(sum.lower()) : sum.lower(); }
    // Returns true if a number is within the limit, given the sign of its difference from the sum.
    bool holds(int difference) const noexcept { return difference < (is_strict ? 0 : 1); }
};

}  // namespace ecods::exact
