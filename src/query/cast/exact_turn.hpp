// ExactTurn is the rotation of a turn at one time, as integers.
#pragma once

#include "ecods/turn.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/number/integer.hpp"
#include "exact/number/polynomial.hpp"

namespace ecods {

// ExactTurn holds integers a, b >= 0 and v such that the quaternion at time s is a positive multiple of (a, b v); and s
// itself. The body has turned by twice the angle of the vector (a, b |v|).
struct ExactTurn {
    ExactTurn(const Quaternion& q, exact::BinaryFraction s);

    exact::BinaryFraction time;
    exact::Integer a, b;
    exact::LongVector3 v;
};

}  // namespace ecods
