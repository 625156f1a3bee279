// A RootSum is the sum of a rational number and the square root of a rational number, each of either sign. Distances of
// rounded bodies and the coordinates of their points are such numbers.
#pragma once

#include <cstdint>

#include "exact/number/integer.hpp"
#include "exact/number/scaled_integer.hpp"

namespace ecods::exact {

// A RootSum is (x / z) 2^e + sqrt(y / w) 2^f, or the difference of the two parts if `is_subtracted`. y >= 0; z and w
// are positive.
struct RootSum {
    Integer x, z{std::int64_t{1}};
    int e = 0;
    Integer y, w{std::int64_t{1}};
    int f = 0;
    bool is_subtracted = false;

    // Returns the sign of the root part: -1 if a root is subtracted, 1 if it is added, 0 if it is zero.
    int root_sign() const noexcept { return y.is_zero() ? 0 : is_subtracted ? -1 : 1; }
};

// Returns whole / den + length / sqrt(square). den and square must be positive, and square 4^n times an integer.
RootSum root_sum(const ScaledInteger& whole, const Integer& den, const ScaledInteger& length,
                 const ScaledInteger& square);

// Returns (x + sqrt(y)) / z, or (x - sqrt(y)) / z if is_subtracted. z must be positive, and y >= 0 have an even
// exponent.
RootSum root_quotient(const ScaledInteger& x, const ScaledInteger& y, const ScaledInteger& z, bool is_subtracted);

// Returns the sign of |x / z| 2^e - sqrt(y / w) 2^f.
int compare_parts(const RootSum& sum);

// Returns the sign of the sum, -1, 0 or 1.
//
// If the two parts have one sign, or one part is zero, the sum has the sign of a part that is not zero; otherwise it
// has the sign of the greater part. The parts are compared by their squares, x^2 w 4^e and y z^2 4^f. So no number is
// squared twice: if x, y, z and w have a, b, c and d bits, the longest number has max(2a + d, b + 2c) bits, and as many
// more as the exponents of the two squares differ.
int sign(const RootSum& sum);

// Returns factor * sum + more.
RootSum affine(const ScaledInteger& factor, const RootSum& sum, const ScaledInteger& more);

// Returns the sign of a - b.
//
// Let U be the difference of the rational parts, and r, q the roots of a and b, signed. a - b = (U + r) - q. If U + r
// and q have different signs, the signs decide. Otherwise the squares decide: (U + r)^2 - q^2 = U^2 + r^2 - q^2 + 2 U r
// is again the sum of a rational number and a root. So no number is squared more than twice.
int compare(const RootSum& a, const RootSum& b);
int compare(const RootSum& a, const ScaledInteger& b);

}  // namespace ecods::exact
