// Two numbers between which the first time is at which two triangles share a point, of which the first is moved by
// time times a vector; from one guess at what decides it.
#pragma once

#include "ecods/mesh.hpp"
#include "exact/measure/contact/guess_contact.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// A vector of doubles: its largest coordinate has 53 digits or is -2^53, others are low by less than one unit.
ScaledVector scaled_motion(const Vec3& m) noexcept;

// Whatever the guess is, the interval contains the time: from time 0 on they share no point before `lower`, which is
// infinity if they share none and says nothing if it is 0; and they do not share their first point after `upper`, which
// is infinity if it is not known whether they share one. In any rounding mode, with or without flush-to-zero or fused
// multiply-add. `pair` has the points at time 0.
Enclosure enclose_contact(const IntegerPair& pair, const ScaledVector& m, const ContactGuess& guess) noexcept;

}  // namespace ecods::exact
