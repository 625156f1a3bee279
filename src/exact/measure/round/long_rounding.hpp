// Rounds quotients and directions of numbers of any length.
#pragma once

#include "ecods/pose.hpp"
#include "exact/number/long_vector.hpp"

namespace ecods::exact {

// Returns num / den, rounded once to the nearest double, ties to even; a zero is +0. den must not be 0.
double round_quotient(const ScaledInteger& num, const ScaledInteger& den);

// Returns the point with the coordinates num / den, each rounded once.
Vec3 round_point(const ScaledLongVector& num, const ScaledInteger& den);

// Returns v / |v|, each coordinate rounded once. v must not be zero.
Vec3 round_direction(const ScaledLongVector& v);

}  // namespace ecods::exact
