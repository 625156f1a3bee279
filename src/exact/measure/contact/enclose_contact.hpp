// enclose_contact() computes lower and upper bounds of the first time at which two triangles share a point, if the
// first triangle is translated by time times a vector. One guess of the features that first share a point is used for
// both bounds.
#pragma once

#include "ecods/mesh.hpp"
#include "exact/measure/contact/guess_contact.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// Returns m as a ScaledVector whose largest coordinate has 53 digits or is -2^53. Each other coordinate is rounded down
// by less than one unit.
ScaledVector scaled_motion(const Vec3& m) noexcept;

// Returns an interval that contains the first time from 0 on at which the triangles share a point, even if the guess is
// wrong. The triangles share no point from time 0 until `lower`; `lower` is infinity if they share no point at any such
// time, and 0 if no bound is proved. They share a point at time `upper` or before; `upper` is infinity if it is not
// proved that they share one. `pair` has the points at time 0. The bounds hold in any rounding mode, with or without
// flush-to-zero or fused multiply-add.
Enclosure enclose_contact(const IntegerPair& pair, const ScaledVector& m, const ContactGuess& guess) noexcept;

}  // namespace ecods::exact
