// How the doubles of files become integers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace certificate_checker {

using Integer = mpz_class;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// How many words of 64 bits a number has. A product counts as many units of work as its factors' limbs multiplied.
inline std::uint64_t limbs(const Integer& x) {
    return mpz_size(x.get_mpz_t());
}

// A finite double is digits * 2^exponent. Infinity stands for 2^1024.
struct Parts {
    explicit Parts(double x) {
        const auto bits = std::bit_cast<std::uint64_t>(x);
        const auto field = static_cast<int>(bits >> 52 & 2047);
        const auto fraction = static_cast<long>(bits & 0xfffffffffffff);
        digits = field > 0 ? fraction | 0x10000000000000 : fraction;
        if (std::signbit(x)) digits = -digits;
        exponent = std::max(field, 1) - 1075;
    }
    long digits;
    int exponent;
};
static_assert(sizeof(long) == 8);

// An exponent e of at most 0 such that all these doubles are multiples of 2^e.
template <class Numbers>
int unit_of(const Numbers& numbers) {
    int unit = 0;
    for (const double x : numbers) unit = x == 0 ? unit : std::min(unit, Parts(x).exponent);
    return unit;
}
// x / 2^unit, which must be an integer.
inline Integer integer(double x, int unit) {
    const Parts parts(x);
    Integer result(parts.digits);
    const int shift = parts.exponent - unit;
    shift < 0 ? result >>= -shift : result <<= shift;
    return result;
}
inline std::array<Integer, 3> integers(const std::array<double, 3>& x, int unit) {
    return {integer(x[0], unit), integer(x[1], unit), integer(x[2], unit)};
}

}  // namespace certificate_checker
