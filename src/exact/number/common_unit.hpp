// A CommonUnit is the greatest number of which all given doubles are integer multiples.
//
// Stacked boxes, grids and stairs are made of few lengths. If such a length has many digits (0.1 has 52), so have all
// coordinates. As multiples of that length the coordinates have few digits.
#pragma once

#include <cstdint>
#include <numeric>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {

// A CommonUnit is m * 2^e with m odd; m = 0 as long as only zeros were included. The greatest common divisor of numbers
// m_i * 2^e_i with odd m_i is gcd(m_i) * 2^min(e_i).
struct CommonUnit {
    std::uint64_t m = 0;
    int e = 0;

    // Includes the number odd * 2^exponent. Most calls need not compute a greatest common divisor: generic numbers soon
    // lead to m = 1, and in other input most numbers are multiples of m.
    constexpr void include(std::uint64_t odd, int exponent) noexcept {
        if (odd == 0) return;
        e = m == 0 || exponent < e ? exponent : e;
        if (m != 1 && (m == 0 || odd % m != 0)) m = std::gcd(m, odd);
    }
    constexpr void include(const Dyadic& x) noexcept { include(magnitude(x.m), x.e); }
    // Includes x, whose binary digits from the first to the last that is not zero must be at most 64.
    constexpr void include(const DyadicDifference& x) noexcept {
        if (x.m == 0) return;
        const Uint128 size = size_of(x.m);
        const int zeros = trailing_zeros(size);
        ECODS_ASSERT(bit_width(size) - zeros <= 64);
        include(static_cast<std::uint64_t>(size >> zeros), x.e + zeros);
    }
    // Includes the products of x and every multiple of `unit`. The product of the odd parts must be below 2^64.
    constexpr void include(const Dyadic& x, const CommonUnit& unit) noexcept {
        ECODS_ASSERT(Uint128{magnitude(x.m)} * unit.m >> 64 == 0);
        include(magnitude(x.m) * unit.m, x.e + unit.e);
    }
};

}  // namespace ecods::exact
