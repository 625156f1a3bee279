// How the doubles of files become integers.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace certificate_checker {

using Integer = mpz_class;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// An exponent e of at most 0 such that all these doubles are multiples of 2^e. Infinity stands for 2^1024.
template <class Numbers>
int unit_of(const Numbers& numbers) {
    int unit = 0;
    for (const double x : numbers) unit = x == 0 ? unit : std::min(unit, std::ilogb(x) - 52);
    return unit;
}
// x / 2^unit, which must be an integer.
inline Integer integer(double x, int unit) {
    int exponent = 1025;
    Integer result(std::isinf(x) ? 0x1p52 : std::ldexp(std::frexp(x, &exponent), 53));
    const long shift = exponent - 53 - unit;
    shift < 0 ? result >>= -shift : result <<= shift;
    return result;
}
inline std::array<Integer, 3> integers(const std::array<double, 3>& x, int unit) {
    return {integer(x[0], unit), integer(x[1], unit), integer(x[2], unit)};
}

}  // namespace certificate_checker
