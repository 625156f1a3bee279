// A FixedDigits is a number with 128 digits and an error bound. This file also has operations on integers of 256 bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>

#include "exact/measure/round/scaled_vector.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// A FixedDigits is the interval (digits +- error) 2^exponent. `digits` is 0, or its highest bit is set.
struct FixedDigits {
    Uint128 digits = 0;
    int exponent = 0;
    Uint128 error = 0;

    // Returns the double nearest to all numbers in the interval; nullopt if the numbers do not all round to the same
    // double.
    std::optional<double> rounded() const noexcept {
        if (error >> 96 != 0) return std::nullopt;
        const double low = round_digits({digits - error - 1, exponent, false});
        const double high = round_digits({digits + error < digits ? ~Uint128{0} : digits + error, exponent, false});
        // Bits are compared, because the processor may take subnormal numbers for zero.
        if (std::bit_cast<std::uint64_t>(low) != std::bit_cast<std::uint64_t>(high)) return std::nullopt;
        return low;
    }
};

// Returns x, or the least positive double if x is 0: the rounding of a positive number must not be zero. Compares bits,
// since a processor that flushes subnormal numbers would compare the least double as zero.
inline double at_least_subnormal(double x) noexcept {
    return std::bit_cast<double>(std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(x), 1));
}

inline Int256 size_of(const Int256& x) noexcept {
    return x.high < 0 ? Int256{} - x : x;
}
inline Uint128 largest(const IntegerVector& v) noexcept {
    return std::max({size_of(v[0]), size_of(v[1]), size_of(v[2])});
}

// Returns the number of binary digits of x, which must not be negative.
inline int bit_width(const Int256& x) noexcept {
    return x.high != 0 ? 128 + bit_width(static_cast<Uint128>(x.high)) : bit_width(x.low);
}

// Returns x 2^-shift, rounded down, for -128 < shift < 256. The result must fit into 128 bits.
inline Int128 shifted(const Int256& x, int shift) noexcept {
    if (shift >= 128) return x.high >> (shift - 128);
    if (shift > 0) return static_cast<Int128>(static_cast<Uint128>(x.high) << (128 - shift) | x.low >> shift);
    return static_cast<Int128>(x.low << -shift);
}

// WideVector is a vector of 256-bit integers, for example a cross product. The factors' coordinates must be below
// 2^127.
using WideVector = std::array<Int256, 3>;
inline WideVector cross(const IntegerVector& u, const IntegerVector& v) noexcept {
    WideVector n;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = multiply(u[i], v[j]) - multiply(u[j], v[i]);
    }
    return n;
}
inline int bit_width(const WideVector& v) noexcept {
    return std::max({bit_width(size_of(v[0])), bit_width(size_of(v[1])), bit_width(size_of(v[2]))});
}
inline IntegerVector shifted(const WideVector& v, int shift) noexcept {
    return {shifted(v[0], shift), shifted(v[1], shift), shifted(v[2], shift)};
}

inline Int256 dot_of(const IntegerVector& a, const IntegerVector& b) noexcept {
    return (multiply(a[0], b[0]) + multiply(a[1], b[1])) + multiply(a[2], b[2]);
}
// Returns the squared length of v.
inline Int256 square_of(const IntegerVector& v) noexcept {
    return dot_of(v, v);
}

// Returns 2^252 / sqrt(s) with a relative error of at most 2^-94. s must be in [2^250, 2^254), like the squared length
// of a vector whose largest coordinate has 126 digits.
Uint128 inverse_root(const Int256& s) noexcept;

}  // namespace ecods::exact
