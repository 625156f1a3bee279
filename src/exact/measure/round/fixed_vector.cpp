// Errors are bounded as follows. x is the vector w scaled by 2^up, so that its largest coordinate has 126 digits: 2^125
// <= |x| < 2^127. Each of its coordinates is off by at most e = `error_`, so x is off by at most sqrt(3) e.
//
// Length. inverse_root() is off by 2^-94 of itself, and dropping the last 127 digits of |x|^2 by 2^-123, so that |x| is
// off by less than 2^-93 of itself, and by sqrt(3) e. Cutting the result loses one unit.
//
// Direction. For two vectors, |x / |x| - y / |y|| <= 2 |x - y| / |x|. So a coordinate of x / |x| is off by less than
// 2 sqrt(3) e / 2^125, which is less than 7 e units of 2^-126; by 2^-94 of at most 1 for the inverse root, which is
// 2^32 units; and by one unit for cutting. The product with r = m 2^k is off by m times as much, before it is cut.
// Claim: verify/proofs/fixed_digits.py
#include "exact/measure/round/fixed_vector.hpp"
#include "base/double_key.hpp"

#include <algorithm>

#include "exact/number/dyadic.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

namespace {

// Returns the bits of the normal double nearest to all numbers (size +- error) 2^unit. Returns nullopt if the 64
// leading digits of `size` do not decide. Cutting the size and the error to these digits adds less than 2 to the error.
// The error must be less than a quarter of the double's last digit, so that it reaches at most one middle of two
// doubles, even at a power of two.
std::optional<std::uint64_t> round_leading(Uint128 size, Uint128 error, int unit) noexcept {
    constexpr int dropped = 64 - 53, least = -1074, most = 971;
    constexpr std::uint64_t middle = std::uint64_t{1} << (dropped - 1);
    const int cut = bit_width(size) - 64, e = unit + cut + dropped;
    if (cut < 0 || e < least || e > most) return std::nullopt;
    const auto top = static_cast<std::uint64_t>(size >> cut);
    const Uint128 off = (error >> cut) + 2;
    const std::uint64_t rest = top & (2 * middle - 1), away = rest > middle ? rest - middle : middle - rest;
    if (off >= middle / 2 || away <= off) return std::nullopt;
    return (static_cast<std::uint64_t>(e - least) << 52) + (top >> dropped) + (rest > middle ? 1 : 0);
}

}  // namespace

std::optional<double> FixedNumber::rounded(int unit) const noexcept {
    if (value == 0 && error == 0) return 0;
    const Uint128 size = size_of(value);
    if (size <= error) return std::nullopt;
    if (const auto bits = round_leading(size, error, unit)) return with_sign(*bits, value < 0);
    if (error == 0) return round_integer(widened(value), unit);  // it may be the middle of two doubles
    const int up = 128 - bit_width(size);
    if (bit_width(error) + up > 96) return std::nullopt;
    const std::optional<double> of_size = FixedDigits{size << up, unit - up, error << up}.rounded();
    if (!of_size) return std::nullopt;
    return with_sign(std::bit_cast<std::uint64_t>(*of_size), value < 0);
}

std::optional<double> FixedNumber::rounded_distance(int unit) const noexcept {
    const std::optional<double> result = rounded(unit);
    const bool is_lost = result && key_of(*result) == 0 && value != 0;
    return is_lost ? std::nullopt : result;
}

FixedNumber fixed_number(double x, int unit) noexcept {
    const Dyadic term = decode(x);
    if (term.m == 0) return {};
    FixedNumber result;
    add_term(result.value, term.m, term.e - unit);
    result.error = term.e < unit ? 1 : 0;
    return result;
}

std::optional<FixedVector> FixedVector::of(const IntegerVector& w, const ErrorBounds& errors) noexcept {
    constexpr int error_bits_max = 88;
    FixedVector result;
    result.errors_ = errors;
    const int width = bit_width(largest(w)), up = 126 - width;
    const std::uint64_t error = result.largest_error();
    if (width == 0 || (error != 0 && static_cast<int>(std::bit_width(error)) + up > error_bits_max)) {
        return std::nullopt;
    }
    result.up_ = up;
    if (error != 0) result.error_ = Uint128{error} << up;
    result.x_ = {w[0] << up, w[1] << up, w[2] << up};
    const std::array<bool, 3> zero{result.is_zero(0), result.is_zero(1), result.is_zero(2)};
    result.axis_ = zero[1] && zero[2] ? 0 : zero[0] && zero[2] ? 1 : zero[0] && zero[1] ? 2 : -1;
    if (result.axis_ >= 0) return result;
    result.square_ = square_of(result.x_);
    result.root_ = inverse_root(result.square_);
    return result;
}

// Returns |w| 2^d. The error of |w|, sqrt(3) times the largest error of a coordinate, is bounded by 2 times that error.
// width() + d <= 124 and the limit of errors in of() leave 2 error 2^d below 2^86.
FixedNumber FixedVector::length(int d) const noexcept {
    const Uint128 doubled = 2 * largest_error();
    const Uint128 of_errors = d >= 0 ? doubled << d : (doubled >> std::min(-d, 127)) + (doubled != 0 ? 1 : 0);
    if (axis_ >= 0) {
        const Uint128 size = size_of(x_[static_cast<std::size_t>(axis_)]);
        const int drop = std::min(up_ - d, 127);
        const Uint128 kept = size >> drop;
        return {static_cast<Int128>(kept), of_errors + (kept << drop != size ? 1 : 0)};
    }
    const int shift = 125 + up_ - d;
    if (shift >= 256) return {0, of_errors + 1};
    const Int128 value = shifted(multiply_halves(static_cast<Uint128>(shifted(square_, 127)), root_), shift);
    return {value, (static_cast<Uint128>(value) >> 93) + of_errors + 2};
}

FixedNumber FixedVector::direction(std::size_t k) const noexcept {
    if (axis_ >= 0) {
        if (static_cast<int>(k) != axis_) return {};
        const Int128 one = Int128{1} << unit_digits;
        return {x_[k] < 0 ? -one : one, 0};
    }
    if (is_zero(k)) return {};
    return {shifted(multiply_unsigned(x_[k], root_), 252 - unit_digits), 7 * error_ + (Uint128{1} << 32) + 1};
}

FixedRadius::FixedRadius(double r, int unit) noexcept : whole_(fixed_number(r, unit)) {
    const Dyadic radius = decode(r);
    if (radius.m == 0) return;
    const int up = 62 - static_cast<int>(std::bit_width(static_cast<std::uint64_t>(radius.m)));
    m_ = radius.m << up;
    shift_ = FixedVector::unit_digits - (radius.e - up - unit);
}

// Returns r n, from the product of m_ and n in two parts. r < 2^(unit + 120) and m_ >= 2^61 leave shift_ >= 68. A
// direction without error is along an axis.
FixedNumber FixedRadius::times(const FixedNumber& n) const noexcept {
    if (m_ == 0 || (n.value == 0 && n.error == 0)) return {};
    if (n.error == 0) return {n.value < 0 ? -whole_.value : whole_.value, whole_.error};
    const Int128 high = Int128{static_cast<std::int64_t>(n.value >> 64)} * m_;
    const Uint128 low = Uint128{static_cast<std::uint64_t>(n.value)} * static_cast<std::uint64_t>(m_);
    const Int128 product = high + static_cast<Int128>(low >> 64);
    return {product >> std::min(shift_ - 64, 127), (n.error >> std::min(shift_ - 62, 127)) + 3};
}

}  // namespace ecods::exact
