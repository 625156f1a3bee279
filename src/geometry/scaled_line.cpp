#include "geometry/scaled_line.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "base/next.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double length_min = 0x1p-900;
constexpr double coordinate_max = 0x1p1021;  // differences of larger coordinates may overflow

// Returns the exponent of x, or -1023 if x is subnormal. x must not be zero.
int exponent_of(double x) noexcept {
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) - 1023;
}

// Returns 2^e. The result must be a normal number.
double power_of_two(int e) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}

// Holds a lower and an upper bound of x 2^e, for x >= 0. The bounds are computed from the bits of x, without rounding,
// and no subnormal number is taken for zero.
struct Scaled {
    double low, high;
};
Scaled scaled(double x, int e) noexcept {
    if (key_of(x) == 0) return {0, 0};
    const int exponent = exponent_of(x);
    if (exponent == 1024) return {infinity, infinity};
    const int sum = exponent + e;
    if (sum > 1023) return {std::numeric_limits<double>::max(), infinity};
    if (exponent < -1022) return {0, sum >= -1023 ? power_of_two(sum + 1) : 0x1p-1021};
    if (sum < -1022) return {0, 0x1p-1021};
    const double exact = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) +
                                               static_cast<std::uint64_t>(static_cast<std::int64_t>(e) * (1LL << 52)));
    return {exact, exact};
}

}  // namespace

// Sets the scaled direction d and its error bound. With u' = 2^-52, a difference of two coordinates has a relative
// error of u'. Numbers that underflow, or are subnormal and taken for zero, add an error of less than 2^-1020 before
// the direction is scaled, by at most 2^900.
// Claim: verify/proofs/lines_and_times.py
ScaledLine::ScaledLine(const Line& line) noexcept : a(line.a) {
    is_point = !line.is_ray;
    int halvings = 0;
    if (line.is_ray) {
        d = line.b;
    } else {
        for (int k = 0; k < 3; ++k) is_point = is_point && key_of(line.a[k]) == key_of(line.b[k]);
        const double size = std::max(line.a.cwiseAbs().maxCoeff(), line.b.cwiseAbs().maxCoeff());
        if (size > coordinate_max) {
            halvings = 1;
            d = 0.5 * line.b - 0.5 * line.a;
        } else {
            d = line.b - line.a;
        }
    }
    const double length = d.cwiseAbs().maxCoeff();
    is_known = length >= length_min;
    if (is_known) {
        const int e = std::min(exponent_of(length), 1022);
        d *= power_of_two(-e);
        exponent = e + halvings;
        for (int k = 0; k < 3; ++k) d_error[k] = (line.is_ray ? 0 : two_u * std::abs(d[k])) + 0x1p-119;
    } else {
        d.setZero();
    }
    const Scaled end = scaled(line.end, exponent);
    end_low = end.low;
    end_high = end.high;
}

double ScaledLine::scaled_above(double parameter) const noexcept {
    return scaled(parameter, exponent).high;
}
double ScaledLine::unscaled_above(double parameter) const noexcept {
    return scaled(parameter, -exponent).high;
}

}  // namespace ecods
