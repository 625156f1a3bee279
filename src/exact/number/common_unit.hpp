// The largest number of which some doubles are all integer multiples.
//
// Stacked boxes, grids and stairs are made of few lengths. Their coordinates have many digits if the length has (0.1
// has 52), but counted in that length they are short.
#pragma once

#include <cstdint>
#include <numeric>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// m * 2^e with m odd; m = 0 while every number seen was zero. The greatest common divisor of numbers m * 2^e with odd m
// is that of their m, times the smallest of their powers of two.
struct CommonUnit {
    std::uint64_t m = 0;
    int e = 0;

    // Further multiples need no greatest common divisor, and are cheap: generic numbers soon have no odd divisor in
    // common, and others repeat one.
    constexpr void include(std::uint64_t odd, int exponent) noexcept {
        if (odd == 0) return;
        e = m == 0 || exponent < e ? exponent : e;
        if (m != 1 && (m == 0 || odd % m != 0)) m = std::gcd(m, odd);
    }
    constexpr void include(const Dyadic& x) noexcept { include(magnitude(x.m), x.e); }
    // `x` must have at most 64 bits between its first digit and its last.
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
