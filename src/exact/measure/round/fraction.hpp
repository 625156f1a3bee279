// A Fraction is a rational number >= 0, for parameters of a line and for times.
#pragma once

#include <cstdint>

#include "ecods/pose.hpp"
#include "exact/number/kernel.hpp"
#include "exact/number/limbs.hpp"
#include "exact/number/natural.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

// A numerator or denominator has at most fraction_limbs limbs: it is a determinant of three differences of points, or
// shorter.
inline constexpr std::size_t fraction_limbs = 3 * limb_count_max;
static_assert(determinant_bits(LimbKernel<limb_count_max>::coordinate_bits) <= static_cast<int>(64 * fraction_limbs));

// A FractionRef refers to the two parts of a fraction num / den, den > 0.
struct FractionRef {
    NaturalSpan num;
    NaturalSpan den;
};

// A Fraction holds num / den, den > 0.
struct Fraction {
    Natural<fraction_limbs> num;
    Natural<fraction_limbs> den{1};

    FractionRef ref() const noexcept { return {num.limbs(), den.limbs()}; }
};

// A Ratio is a fraction num / den of either sign. den may be negative, but not zero.
template <int L>
struct Ratio {
    Magnitude<L> num, den;

    int sign() const noexcept {
        const int s = exact::sign<L>(num);
        return den.negative ? -s : s;
    }
    FractionRef size() const noexcept { return {without_leading_zeros(num.limbs), without_leading_zeros(den.limbs)}; }
};

// Returns x as a fraction, exactly. x must be finite and not negative. The denominator of 2^-1074 has 17 limbs; no
// numerator has more than 16.
Fraction fraction_of(double x) noexcept;

// Return the sign of first - second, or of first - x. x must be >= 0, and may be infinity.
int compare(const FractionRef& first, const FractionRef& second) noexcept;
int compare(const FractionRef& first, double x) noexcept;
template <int L>
int compare(const Ratio<L>& x, const Ratio<L>& y) noexcept {
    const int a = x.sign(), b = y.sign();
    if (a != b || a == 0) return a - b;
    return a * compare(x.size(), y.size());
}

// Returns the double nearest to x, ties to even: at least 2^-1074 if x is positive, and infinity if x is above the
// largest double. The floating-point environment has no effect.
double round_fraction(const FractionRef& x) noexcept;

// A RoundedOnLine holds a parameter num / den of a line, and the point there: a + (b - a) num / den, or a + b num / den
// if `is_direction`. Each number is rounded once to the nearest double, ties to even. A zero is +0, and a positive
// parameter is rounded to at least 2^-1074.
struct RoundedOnLine {
    double parameter = 0;
    Vec3 point = Vec3::Zero();
};
RoundedOnLine round_on_line(const Vec3& a, const Vec3& b, bool is_direction, const FractionRef& at) noexcept;

}  // namespace ecods::exact
