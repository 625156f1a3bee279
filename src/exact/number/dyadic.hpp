// A Dyadic is a double as an integer times a power of two, read from its bits: no floating-point instruction takes
// part.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// Holds m * 2^e with m odd, or m = 0 and e = 0. |m| < 2^53, -1074 <= e <= 971.
struct Dyadic {
    std::int64_t m = 0;
    int e = 0;
};

constexpr int mantissa_bits = 53;

// Returns x = m * 2^e; `x` must be finite.
constexpr Dyadic decode(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    ECODS_ASSERT(biased != 0x7ff);
    std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased != 0) fraction |= std::uint64_t{1} << 52;
    if (fraction == 0) return {};
    const int zeros = std::countr_zero(fraction);
    const auto m = static_cast<std::int64_t>(fraction >> zeros);
    // A subnormal has the exponent of the smallest normal number, without its leading one.
    const int exponent = (biased == 0 ? 1 : biased) - 1075 + zeros;
    return {bits >> 63 ? -m : m, exponent};
}

constexpr std::uint64_t magnitude(std::int64_t m) noexcept {
    return m < 0 ? -static_cast<std::uint64_t>(m) : static_cast<std::uint64_t>(m);
}

// A BitRange is the range of the binary digits of some numbers: all are multiples of 2^low, and below 2^high in
// magnitude. It is empty while every number seen was zero.
struct BitRange {
    static constexpr int none = 1 << 20;
    int low = none;
    int high = -none;

    constexpr bool empty() const noexcept { return low == none; }
    constexpr int width() const noexcept { return empty() ? 0 : high - low; }

    constexpr void include(const Dyadic& x) noexcept {
        if (x.m != 0) include(x.e, x.e + static_cast<int>(std::bit_width(magnitude(x.m))));
    }
    constexpr void include(const BitRange& range) noexcept {
        if (!range.empty()) include(range.low, range.high);
    }
    constexpr void include(int new_low, int new_high) noexcept {
        low = new_low < low ? new_low : low;
        high = new_high > high ? new_high : high;
    }
    // Returns the range of all products of a number of range a and a number of range b.
    friend constexpr BitRange operator*(const BitRange& a, const BitRange& b) noexcept {
        if (a.empty() || b.empty()) return {};
        return {a.low + b.low, a.high + b.high};
    }
};

// Holds the difference m * 2^e of two doubles.
struct DyadicDifference {
    Int128 m = 0;
    int e = 0;

    constexpr BitRange digits() const noexcept {
        BitRange range;
        if (m == 0) return range;
        const Uint128 size = size_of(m);
        range.include(e + trailing_zeros(size), e + bit_width(size));
        return range;
    }
    // Returns the difference divided by 2^low. 2^low must divide the difference, and the result must fit.
    constexpr Int128 at(int low) const noexcept {
        ECODS_ASSERT(m == 0 || (digits().low >= low && digits().high - low <= 127));
        return m == 0 ? 0 : e >= low ? m << (e - low) : m >> (low - e);
    }
};

// Returns a - b, or nothing if a and b are too far apart for 127 bits and a sign.
constexpr std::optional<DyadicDifference> subtract(const Dyadic& a, const Dyadic& b) noexcept {
    BitRange both;
    both.include(a);
    both.include(b);
    if (both.empty()) return DyadicDifference{};
    if (both.width() + 2 > 128) return std::nullopt;
    const auto at_low = [&](const Dyadic& x) { return x.m == 0 ? Int128{0} : Int128{x.m} << (x.e - both.low); };
    return DyadicDifference{at_low(a) - at_low(b), both.low};
}

}  // namespace ecods::exact
