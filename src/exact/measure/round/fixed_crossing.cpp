// The parameter s of a crossing is (d x v) / (u x v), where both products are of two coordinates. With errors b of d
// and e of u and v, and D, U, V upper bounds of coordinates, d x v is off by 2 (b (V + e) + D e), and u x v by 2 e (U +
// V + e). Both are shifted such that the divisor has 126 digits; a shift to the right costs each number, and each
// bound, less than a unit. With N and M, which are off by n and m, and s <= 1 + 2^-40, N / M is off by less than (n +
// m) (1 + 2^-38) / 2^125 if m is below 2^80: that is less than (n + m) 2^-124.
//
// The quotient is 60 digits q from doubles, and a correction. q is off by 2^-50: four roundings of 2^-52 at most, and
// digits of N and M below 2^64, which are 2^-60 of M. The rest N - q M is exact, and at most 2^-49 M. Its upper digits,
// divided in doubles, give 45 more digits: off by 2^-50 of 2^-49 2^105 = 2^56 units, by a digit of the rest that was
// cut, 2^84 of M > 2^125, and by the last cut: less than 2^7 units together.
// Claim: verify/proofs/fixed_shift.py
#include "exact/measure/round/fixed_crossing.hpp"

#include <algorithm>

#include "exact/measure/round/fixed_digits.hpp"

namespace ecods::exact {
namespace {

constexpr int divisor_digits = 126, coarse_digits = 60, fine_digits = FixedParameter::digits - coarse_digits;

// A Factor is a number of up to 126 digits with an error bound below 2^80.
struct Factor {
    Int128 value;
    Uint128 error;
};

Int256 product(const std::array<Int128, 2>& x, const std::array<Int128, 2>& y) noexcept {
    return multiply(x[0], y[1]) - multiply(x[1], y[0]);
}
Uint128 larger_of(const std::array<Int128, 2>& x) noexcept {
    return std::max(size_of(x[0]), size_of(x[1]));
}
Int256 twice(const Int256& x) noexcept {
    return x + x;
}

// Returns x 2^-shift with its error bound; nullopt if the result has more than 126 digits, or the bound is 2^80 or
// more.
std::optional<Factor> scaled(const Int256& x, const Int256& error, int shift) noexcept {
    if (bit_width(size_of(x)) - shift > divisor_digits) return std::nullopt;
    if (sign(error) == 0) return Factor{shifted(x, shift), shift > 0 ? Uint128{1} : 0};
    if (shift < 0 || bit_width(error) - shift > 79) return std::nullopt;
    return Factor{shifted(x, shift), static_cast<Uint128>(shifted(error, shift)) + 2};
}

double top_of(Int128 x) noexcept {
    return static_cast<double>(static_cast<std::int64_t>(x >> 64));
}

// Returns a / b in units of 2^-FixedParameter::digits, for 0 <= a <= b and b >= 2^125.
Int128 divide(Int128 a, Int128 b) noexcept {
    const double divisor = top_of(b);
    const auto coarse = static_cast<std::int64_t>(top_of(a) / divisor * 0x1p60);
    const Int256 rest = multiply(a, Int128{1} << coarse_digits) - multiply(b, Int128{coarse});
    const auto upper = static_cast<double>(static_cast<std::int64_t>(shifted(rest, 84)));
    const auto fine = static_cast<std::int64_t>(upper / divisor * 0x1p65);
    return (Int128{coarse} << fine_digits) + fine;
}

}  // namespace

FixedNumber FixedParameter::times(Int128 u, std::uint64_t of_u) const noexcept {
    if (u == 0 && of_u == 0) return {};
    const Uint128 of_parameter = (((size_of(u) >> 64) + 1) * error) >> (digits - 64);
    return {shifted(multiply(u, value), digits), of_parameter + 2 * of_u + 2};
}

std::optional<FixedParameter> find_crossing(const std::array<FixedNumber, 2>& d, const std::array<Int128, 2>& u,
                                            const std::array<Int128, 2>& v, std::uint64_t error) noexcept {
    const std::array<Int128, 2> way{d[0].value, d[1].value};
    const Uint128 of_way = std::max(d[0].error, d[1].error);
    const auto e = static_cast<Int128>(error);
    Int256 num = product(way, v), den = product(u, v);
    Int256 of_num{}, of_den{};
    if (of_way != 0 || error != 0) {
        of_num = twice(multiply(static_cast<Int128>(of_way), static_cast<Int128>(larger_of(v)) + e) +
                       multiply(static_cast<Int128>(larger_of(way)), e));
    }
    if (error != 0) of_den = twice(multiply(static_cast<Int128>(larger_of(u) + larger_of(v)) + e, e));
    if (den.high < 0) {
        num = Int256{} - num;
        den = Int256{} - den;
    }
    const int shift = bit_width(den) - divisor_digits;
    if (shift <= -divisor_digits) return std::nullopt;
    const auto a = scaled(num, of_num, shift), b = scaled(den, of_den, shift);
    if (!a || !b) return std::nullopt;
    const Int128 inside = std::clamp<Int128>(a->value, 0, b->value);
    const Uint128 off = (((a->error + b->error) >> (124 - FixedParameter::digits)) + 1) + (1 << 7);
    if (off >> 62 != 0) return std::nullopt;
    return FixedParameter{divide(inside, b->value), static_cast<std::uint64_t>(off)};
}

}  // namespace ecods::exact
