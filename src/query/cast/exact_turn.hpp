// ExactTurn is the rotation of a turn at one time, as integers.
#pragma once

#include <array>
#include <span>

#include "ecods/turn.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"
#include "exact/number/polynomial.hpp"

namespace ecods {

// Holds the quaternion (a, b v) at time s, times a positive number, with integers a, b >= 0 and v; and s itself. The
// body has turned by twice the angle of the vector (a, b |v|).
struct ExactTurn {
    ExactTurn(const Quaternion& q, exact::BinaryFraction s);

    // Returns the rotated vector g times `norm`.
    exact::LongVector3 rotated(const exact::LongVector3& g) const;

    exact::BinaryFraction time;
    exact::Integer a, b;
    exact::LongVector3 v;
    exact::Integer norm;  // a^2 + b^2 v.v
};

// Returns x, which must be finite and not negative.
exact::BinaryFraction binary_fraction(double x);
// Returns the number half-way between two doubles that are finite and not negative.
exact::BinaryFraction middle_of(double x, double y);

}  // namespace ecods
