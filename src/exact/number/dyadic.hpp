// A Dyadic is a double as an integer times a power of two. The integer and the power are read from the double's bits,
// without floating-point instructions.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// A Dyadic is the number m * 2^e: m is odd, or m = 0 and e = 0. |m| < 2^53, -1074 <= e <= 971.
struct Dyadic {
    std::int64_t m = 0;
    int e = 0;
};

constexpr int mantissa_bits = 53;

// Returns x as a Dyadic; x must be finite.
constexpr Dyadic decode(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    ECODS_ASSERT(biased != 0x7ff);
    std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    if (biased != 0) fraction |= std::uint64_t{1} << 52;
    if (fraction == 0) return {};
    const int zeros = std::countr_zero(fraction);
    const auto m = static_cast<std::int64_t>(fraction >> zeros);
    // A subnormal number has the exponent of the least normal number, and no implicit leading one.
    const int exponent = (biased == 0 ? 1 : biased) - 1075 + zeros;
    return {bits >> 63 ? -m : m, exponent};
}

constexpr std::uint64_t magnitude(std::int64_t m) noexcept {
    return m < 0 ? -static_cast<std::uint64_t>(m) : static_cast<std::uint64_t>(m);
}

// A BitRange is the range of binary digits that some numbers have: all are multiples of 2^low, and below 2^high in
// magnitude. The range is empty as long as only zeros were included.
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
    // Returns the range of the products of all numbers in range a and all numbers in range b.
    friend constexpr BitRange operator*(const BitRange& a, const BitRange& b) noexcept {
        if (a.empty() || b.empty()) return {};
        return {a.low + b.low, a.high + b.high};
    }
};

// A DyadicDifference is m * 2^e, the difference of two doubles.
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
    // Returns the difference divided by 2^low. 2^low must divide the difference, and the result must fit into 127 bits
    // and a sign.
    constexpr Int128 at(int low) const noexcept {
        ECODS_ASSERT(m == 0 || (digits().low >= low && digits().high - low <= 127));
        return m == 0 ? 0 : e >= low ? m << (e - low) : m >> (low - e);
    }
};

// Returns a - b; nullopt if the difference may not fit into 127 bits and a sign.
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
