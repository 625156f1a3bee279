#include "exact/measure/line/round_crossing.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "exact/measure/round/fixed_digits.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {
namespace {

constexpr int coordinate_bits = TwoLimbKernel::coordinate_bits;
constexpr int normal_bits = 126;  // number of leading bits of n that are kept
static_assert(difference_bits(coordinate_bits) <= 127 && minor_bits(coordinate_bits) <= 255);
static_assert(normal_bits + coordinate_bits + 2 <= 255, "a sum of three products fits 256 bits with its sign");

// digits_min is the least number of digits that a sum must have more than its error bound.
constexpr int digits_min = 70;

int width_of(const IntegerVector& p) noexcept {
    return bit_width(size_of(p[0]) | size_of(p[1]) | size_of(p[2]));
}
// Returns the number of digits of x, or of its complement if x is negative: equal to the number of digits of |x|, or
// one less.
int width_of(const Int256& x) noexcept {
    const auto sign = static_cast<Uint128>(x.high >> 127);
    const Uint128 high = static_cast<Uint128>(x.high) ^ sign, low = x.low ^ sign;
    return high != 0 ? 128 + bit_width(high) : bit_width(low);
}

// A Normal holds n / 2^shift, rounded down to normal_bits leading digits.
struct Normal {
    IntegerVector n;
    int shift;
};

Normal normal_of(const std::array<IntegerVector, 3>& corners) noexcept {
    const WideVector n = cross(difference(corners[1], corners[0]), difference(corners[2], corners[0]));
    const int width = std::max({width_of(n[0]), width_of(n[1]), width_of(n[2])});
    const int shift = std::max(width - normal_bits, 0);
    return {shifted(n, shift), shift};
}

// A LeadingDot holds the leading digits of a sum, rounded towards zero: the sum is about digits 2^exponent. digits is 0
// if the sum is zero, or so short that its error is too large.
struct LeadingDot {
    Uint128 digits = 0;
    int exponent = 0;
    bool is_negative = false;
};

// Returns `count` <= 127 leading digits of n . p. If shift > 0, each coordinate of n is off by less than 1, and n . p
// by less than 2^(width of p + 2).
LeadingDot leading_of_dot(const Normal& normal, const IntegerVector& p, int count) noexcept {
    const IntegerVector& n = normal.n;
    Int256 sum = multiply(n[0], p[0]) + multiply(n[1], p[1]) + multiply(n[2], p[2]);
    const bool is_negative = sum.high < 0;
    if (is_negative) sum = Int256{} - sum;
    const int width = width_of(sum), exponent = width - count;
    if (width == 0 || (normal.shift > 0 && width < width_of(p) + 2 + digits_min)) return {};
    if (exponent < 0) return {sum.low << -exponent, exponent, is_negative};
    return {static_cast<Uint128>(shifted(sum, exponent)), exponent, is_negative};
}

// A Between is an interval of positive numbers, from digits 2^exponent to (digits + width) 2^exponent.
struct Between {
    Uint128 digits;
    Uint128 width;
    int exponent;
};

// Sets `rounded` and returns true if all numbers of the interval round to the same normal double. Otherwise returns
// false. `kept` has the leading digits of the interval's lower end. All numbers between the half-way points below and
// above kept + 1 round to kept + 1. This also holds if kept + 1 is a power of two, above which doubles are farther
// apart.
bool round_between(const Between& x, double& rounded) noexcept {
    const int drop = bit_width(x.digits) - mantissa_bits;
    if (drop < 2) return false;
    const Uint128 full = Uint128{1} << drop, half = full >> 1, rest = x.digits & (full - 1);
    if (x.width >= half) return false;
    auto kept = static_cast<std::uint64_t>(x.digits >> drop);
    if (rest > half) {
        if (rest + x.width >= full + half) return false;
        ++kept;
    } else if (rest + x.width >= half) {
        return false;
    }
    const int biased = x.exponent + drop + (mantissa_bits - 1) + 1023;
    if (biased < 1 || biased > 2045) return false;
    // The leading one of `kept` adds one to the exponent, and so does a carry.
    rounded = std::bit_cast<double>((static_cast<std::uint64_t>(biased - 1) << 52) + kept);
    return true;
}

// Sets `rounded` and returns true if all numbers from low 2^exponent to high 2^exponent, of either sign, round to the
// same double. Otherwise returns false.
bool round_between(Int128 low, Int128 high, int exponent, double& rounded) noexcept {
    const auto width = static_cast<Uint128>(high) - static_cast<Uint128>(low);
    if (low > 0) return round_between({static_cast<Uint128>(low), width, exponent}, rounded);
    if (high >= 0 || !round_between({size_of(high), width, exponent}, rounded)) return false;
    rounded = std::bit_cast<double>(std::bit_cast<std::uint64_t>(rounded) | std::uint64_t{1} << 63);
    return true;
}

// Sets `rounded` to x + s d 2^unit, rounded once, for all s in the interval from digits 2^exponent to (digits + width)
// 2^exponent. Returns false if the values do not all round to one double.
//
// Let m be the 63 leading digits of |d|: |d| is between m and m + 1 units. So the product is between digits m and
// digits m + width (m + 1) + digits. Product and x are then converted to a common unit, in which the longer of them has
// at most 120 digits. Dropping digits makes a magnitude smaller by less than 1. All numbers stay below 2^122.
bool round_coordinate(double x, Int128 d, int unit, std::uint64_t digits, std::uint64_t width, int exponent,
                      double& rounded) noexcept {
    const Dyadic from = decode(x);
    if (d == 0) {
        rounded = from.m == 0 ? 0 : x;
        return true;
    }
    constexpr int bits_max = 120;
    const Uint128 size = size_of(d);
    const int lost = std::max(bit_width(size) - 63, 0);
    const auto m = static_cast<std::uint64_t>(size >> lost);
    const Uint128 product = Uint128{digits} * m;
    const Uint128 spread = Uint128{width} * m + (lost > 0 ? Uint128{width} + digits : 0);
    const int e = exponent + unit + lost;
    const int top_of_x = from.m == 0 ? e : from.e + static_cast<int>(std::bit_width(magnitude(from.m)));
    const int common = std::max(e + bit_width(product), top_of_x) - bits_max;
    const auto in_common = [&](Uint128 y, int of) -> Uint128 {
        if (y == 0) return 0;  // zero is 0 in any unit
        if (of >= common) return y << (of - common);
        return common - of < 128 ? y >> (common - of) : 0;
    };
    const auto low = static_cast<Int128>(in_common(product, e)),
               high = static_cast<Int128>(in_common(product + spread, e) + 1);
    const auto x_size = static_cast<Int128>(in_common(magnitude(from.m), from.e));
    const int is_cut = from.m != 0 && from.e < common ? 1 : 0;
    const Int128 x_low = from.m < 0 ? -x_size - is_cut : x_size, x_high = x_low + is_cut;
    if (d < 0) return round_between(x_low - high, x_high - low, common, rounded);
    return round_between(x_low + low, x_high + high, common, rounded);
}

}  // namespace

// The quotient's error is bounded as follows. If n was cut, n . p and n . d have relative errors of at most 2^-69:
// leading_of_dot() returns only sums of at least 2^(digits_min - 1) times their error bounds. The quotient q of 127
// digits of n . p by 64 digits of n . d has 63 or 64 digits. Its divisor is too small by a relative error below 2^-63,
// which makes q too large by less than 2; rounding down makes q too small by less than 1. The errors of both sums, and
// the dropped digits of the dividend, change q by less than 2^-4. So the true quotient is between q - 3 and q + 2.
// Claim: verify/proofs/fixed_digits.py
bool round_crossing(const LineInUnits& line, const std::array<IntegerVector, 3>& corners,
                    RoundedCrossing& result) noexcept {
    const Normal n = normal_of(corners);
    const LeadingDot den = leading_of_dot(n, line.direction, 64);
    if (den.digits == 0) return false;
    const LeadingDot num = leading_of_dot(n, corners[0], 127);
    if (num.digits == 0 || num.is_negative != den.is_negative) return false;
    const auto q = static_cast<std::uint64_t>(num.digits / static_cast<std::uint64_t>(den.digits));
    constexpr std::uint64_t too_large = 3, width = 5;
    const std::uint64_t digits = q - too_large;
    const int exponent = num.exponent - den.exponent;
    if (!round_between({digits, width, exponent}, result.at.parameter)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        if (!round_coordinate(line.from[axis], line.direction[k], line.unit, digits, width, exponent,
                              result.at.point[axis])) {
            return false;
        }
    }
    result.facing = den.is_negative ? -1 : 1;
    return true;
}

}  // namespace ecods::exact
