// A CommonUnit is the largest number that some doubles are all integer multiples of.
//
// Stacked boxes, grids and stairs are made of few lengths. If such a length has many digits (0.1 has 52), so have all
// coordinates; counted in units of the length they are short.
#pragma once

#include <cstdint>
#include <numeric>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// Holds the unit m * 2^e with m odd; m = 0 while every number seen was zero. The greatest common divisor of numbers
// m_i * 2^e_i with odd m_i is gcd(m_i) * 2^min(e_i).
struct CommonUnit {
    std::uint64_t m = 0;
    int e = 0;

    // Includes the number odd * 2^exponent. Most calls need no greatest common divisor: generic numbers soon leave
    // m = 1, and on other input the numbers are multiples of m.
    constexpr void include(std::uint64_t odd, int exponent) noexcept {
        if (odd == 0) return;
        e = m == 0 || exponent < e ? exponent : e;
        if (m != 1 && (m == 0 || odd % m != 0)) m = std::gcd(m, odd);
    }
    constexpr void include(const Dyadic& x) noexcept { include(magnitude(x.m), x.e); }
    // Includes `x`, which must have at most 64 bits between its first digit and its last.
    constexpr void include(const DyadicDifference& x) noexcept {
        if (x.m == 0) return;
        const Uint128 size = size_of(x.m);
        const int zeros = trailing_zeros(size);
        ECODS_ASSERT(bit_width(size) - zeros <= 64);
        include(static_cast<std::uint64_t>(size >> zeros), x.e + zeros);
    }
    // Includes x times every multiple of `unit`. The product of the odd parts must be below 2^64.
    constexpr void include(const Dyadic& x, const CommonUnit& unit) noexcept {
        ECODS_ASSERT(Uint128{magnitude(x.m)} * unit.m >> 64 == 0);
        include(magnitude(x.m) * unit.m, x.e + unit.e);
    }
};

}  // namespace ecods::exact
