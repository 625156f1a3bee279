// A rounded body is a core and all points within a radius of it. The point of a rounded body that is closest to another
// body is the core's closest point plus radius times a unit vector; each coordinate is rounded once.
#pragma once

#include <array>

#include "ecods/pose.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/exact_sum.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/number/scaled_integer.hpp"

namespace ecods::exact {

// Radii holds the radii of two bodies, which are finite and not negative.
struct Radii {
    double a = 0, b = 0;

    ExactSum sum() const { return ExactSum(a).plus(b); }
};

// A LongDirection holds an integer vector and its squared length.
struct LongDirection {
    LongVector x;
    Integer square;

    template <int M>
    static LongDirection of(const LimbVector<M>& v, bool is_turned) {
        LongDirection result;
        for (std::size_t k = 0; k < 3; ++k) {
            result.x[k] = Integer(NaturalSpan(v[k].limbs), (v[k].negative != 0) != is_turned);
            result.square = result.square + result.x[k] * result.x[k];
        }
        return result;
    }

    LongDirection operator-() const { return {{-x[0], -x[1], -x[2]}, square}; }
};

// Returns point + radius n / |n| in world coordinates, each rounded once to the nearest double, ties to even; a zero is
// +0. `point` is relative to `origin`. n must not be zero.
Vec3 round_end(const PointRef& origin, const ExactPoint& point, const ScaledInteger& radius, const LongDirection& n);

}  // namespace ecods::exact
