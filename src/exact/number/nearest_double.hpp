// nearest_double() rounds a real number that is known only by comparisons with other numbers.
#pragma once

#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/polynomial.hpp"

namespace ecods::exact {

// Returns x as a BinaryFraction. x must be finite and not negative.
inline BinaryFraction binary_fraction(double x) {
    const Dyadic d = decode(x);
    return d.e >= 0 ? BinaryFraction{Integer(d.m) << d.e, 0} : BinaryFraction{Integer(d.m), -d.e};
}

// Returns the number half-way between the doubles with the keys k >= 0 and k + 1. Infinity counts as 2^1024.
inline BinaryFraction middle_after(std::int64_t k) {
    constexpr std::int64_t infinity = key_of(std::numeric_limits<double>::infinity());
    const BinaryFraction first = binary_fraction(double_of(k));
    const BinaryFraction second =
        k + 1 < infinity ? binary_fraction(double_of(k + 1)) : BinaryFraction{Integer(std::int64_t{1}) << 1024, 0};
    const int bits = first.bits < second.bits ? second.bits : first.bits;
    return {(first.m << (bits - first.bits)) + (second.m << (bits - second.bits)), bits + 1};
}

// Returns the double nearest to a number that is not negative, ties to even; infinity from half-way between the largest
// double and 2^1024 on. compare(m) returns the sign of the number minus m, for m up to `most`, which the number is
// known not to exceed. The galloping search begins at `guess`, which affects only the work.
template <class Compare>
double nearest_double(double guess, Compare&& compare, double most = std::numeric_limits<double>::infinity()) {
    const std::int64_t last = key_of(most);
    // Returns true if the nearest double is after double number k. Of two doubles the one with an even key has an even
    // digit.
    const auto is_after = [&](std::int64_t k) {
        const int side = compare(middle_after(k));
        return side > 0 || (side == 0 && k % 2 != 0);
    };
    const std::int64_t guessed = key_of(guess);
    const std::int64_t key = guessed >= 0 && guessed < last ? guessed : 0;
    std::int64_t below = key, above = key, step = 1;  // the answer is in (below, above]
    if (is_after(key)) {
        do {
            below = above;
            above = step < last - above ? above + step : last;
            step *= 2;
        } while (above < last && is_after(above));
    } else {
        do {
            above = below;
            below = step <= below ? below - step : -1;
            step *= 2;
        } while (below >= 0 && !is_after(below));
    }
    while (above - below > 1) {
        const std::int64_t middle = below + (above - below) / 2;
        (is_after(middle) ? below : above) = middle;
    }
    return double_of(above);
}

}  // namespace ecods::exact
