// Two kinds of numbers, and vectors of either: integers of GMP, and doubles that know how wrong they may be.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace certificate_checker {

inline constexpr double u = 0x1p-53;              // half the distance from 1 to the next double
inline constexpr double underflow = 0x1p-1074;    // at most this is lost where a result is subnormal
inline constexpr double inflation = 1 + 0x1p-48;  // more than the roundings of the few sums of a bound

// The true number is within `error` of `value`. An operation adds what it rounds, u times its result, to what the
// operands are wrong by; the bound is inflated because it is rounded itself. Infinity and NaN are passed on, and no
// comparison that a proof needs holds for them.
struct Approximate {
    double value = 0, error = 0;
};
inline Approximate rounded(double value, double error) {
    return {value, (error + u * std::abs(value) + underflow) * inflation};
}
inline Approximate operator+(const Approximate& a, const Approximate& b) {
    return rounded(a.value + b.value, a.error + b.error);
}
inline Approximate operator-(const Approximate& a, const Approximate& b) {
    return rounded(a.value - b.value, a.error + b.error);
}
inline Approximate operator*(const Approximate& a, const Approximate& b) {
    return rounded(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}

using Integer = mpz_class;
template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> operator-(const Vector<Number>& a, const Vector<Number>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Vector<Number> operator*(const Number& s, const Vector<Number>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Vector<Integer>& a) {
    return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

// The greatest e such that x is a multiple of 2^e. Zero is a multiple of all, and infinity stands for 2^1024.
inline constexpr int no_low_bit = 5000;
inline int low_bit(double x) {
    if (x == 0) return no_low_bit;
    if (std::isinf(x)) return 1024;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    return exponent - 53 + __builtin_ctzll(static_cast<std::uint64_t>(mantissa));
}
// Of all these, and at most 0.
template <class Numbers>
int lowest_bit(const Numbers& numbers) {
    int low = 0;
    for (const double x : numbers) low = std::min(low, low_bit(x));
    return low;
}

// x / 2^low, which must be an integer.
inline Integer integer(double x, int low) {
    const int own = low_bit(x);
    if (x == 0) return 0;
    return Integer(own == 1024 ? 1.0 : std::ldexp(x, -own)) << static_cast<unsigned long>(own - low);
}

}  // namespace certificate_checker
