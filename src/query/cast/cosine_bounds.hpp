// CosineBounds encloses cosine and sine of a rational number in integers, by Taylor's series. The floating-point
// environment and the library of the machine have no effect.
#pragma once

#include "exact/number/polynomial.hpp"

namespace ecods {

// The cosine of t is between (cos - off) / scale and (cos + off) / scale, and the sine alike.
struct CosineBounds {
    exact::Integer cos, sin, off, scale;
};

// Returns the bounds from all terms up to t^degree; 0 <= t <= 4. `off` is at most t^(degree + 1) / (degree + 1)! of the
// scale, times degree + 1.
CosineBounds bound_cosine(const exact::BinaryFraction& t, int degree);

// Returns decide(bounds) for bounds that grow tighter until it returns a sign that is not 0.
template <class Decide>
int decide_by_cosine(const exact::BinaryFraction& t, Decide&& decide) {
    for (int degree = 8;; degree *= 2) {
        if (const int sign = decide(bound_cosine(t, degree)); sign != 0) return sign;
    }
}

}  // namespace ecods
