// CosineBounds encloses cosine and sine of a rational number in integers, by Taylor's series. The floating-point
// environment and the library of the machine have no effect.
#pragma once

#include "exact/number/polynomial.hpp"

namespace ecods {

// CosineBounds states that the cosine of t is between (cos - off) / scale and (cos + off) / scale, and the sine of t
// between (sin - off) / scale and (sin + off) / scale.
struct CosineBounds {
    exact::Integer cos, sin, off, scale;
};

// Returns the bounds that follow from all terms of the series up to t^degree, for 0 <= t <= 4. `off` / `scale` is about
// t^(degree + 1) / (degree + 1)!.
CosineBounds bound_cosine(const exact::BinaryFraction& t, int degree);

// Calls decide(bounds) with bounds of the cosine and sine of t of increasing degree, until decide() returns a sign that
// is not 0. Returns that sign.
template <class Decide>
int decide_by_cosine(const exact::BinaryFraction& t, Decide&& decide) {
    for (int degree = 8;; degree *= 2) {
        if (const int sign = decide(bound_cosine(t, degree)); sign != 0) return sign;
    }
}

}  // namespace ecods
