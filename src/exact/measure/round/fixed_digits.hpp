// FixedDigits are numbers in fixed precision with an error bound; here are also operations on numbers of 256 bits.
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

// Holds (digits +- error) 2^exponent; digits has 128 bits unless it is zero.
struct FixedDigits {
    Uint128 digits = 0;
    int exponent = 0;
    Uint128 error = 0;

    // Returns the nearest double, or nothing if not all numbers in the range round to one double.
    std::optional<double> rounded() const noexcept {
        if (error >> 96 != 0) return std::nullopt;
        const double low = round_digits({digits - error - 1, exponent, false});
        const double high = round_digits({digits + error < digits ? ~Uint128{0} : digits + error, exponent, false});
        // Compares bits: the processor may take subnormal numbers for zero.
        if (std::bit_cast<std::uint64_t>(low) != std::bit_cast<std::uint64_t>(high)) return std::nullopt;
        return low;
    }
};

// Returns the rounding of a positive number: at least the least double. Compares bits, which no mode takes for zero.
inline double at_least_subnormal(double x) noexcept {
    return std::bit_cast<double>(std::max<std::uint64_t>(std::bit_cast<std::uint64_t>(x), 1));
}

inline Int256 size_of(const Int256& x) noexcept {
    return x.high < 0 ? Int256{} - x : x;
}
inline Uint128 largest(const IntegerVector& v) noexcept {
    return std::max({size_of(v[0]), size_of(v[1]), size_of(v[2])});
}

// Returns the number of bits of x >= 0.
inline int bit_width(const Int256& x) noexcept {
    return x.high != 0 ? 128 + bit_width(static_cast<Uint128>(x.high)) : bit_width(x.low);
}

// Returns x 2^-shift, rounded down, for -128 < shift < 256. The result must fit.
inline Int128 shifted(const Int256& x, int shift) noexcept {
    if (shift >= 128) return x.high >> (shift - 128);
    if (shift > 0) return static_cast<Int128>(static_cast<Uint128>(x.high) << (128 - shift) | x.low >> shift);
    return static_cast<Int128>(x.low << -shift);
}

// Holds the cross product of two vectors, whose coordinates have 256 bits if the factors' are below 2^127.
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

// Returns the square of a vector's length.
inline Int256 square_of(const IntegerVector& v) noexcept {
    return (multiply(v[0], v[0]) + multiply(v[1], v[1])) + multiply(v[2], v[2]);
}

// Returns 2^252 / sqrt(s) with a relative error of at most 2^-94, for 2^250 <= s < 2^254. The squared length of a
// vector whose largest coordinate has 126 digits is in this range.
Uint128 inverse_root(const Int256& s) noexcept;

}  // namespace ecods::exact
