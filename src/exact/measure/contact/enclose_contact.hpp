// enclose_contact bounds the first time at which two triangles share a point from below and above. The first triangle
// is translated by time times a vector. One guess of the features that decide is enough for both bounds.
#pragma once

#include "ecods/mesh.hpp"
#include "exact/measure/contact/guess_contact.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// Scales a vector of doubles: its largest coordinate has 53 digits or is -2^53, others are less than one unit too low.
ScaledVector scaled_motion(const Vec3& m) noexcept;

// Returns an interval that contains the time, whatever the guess is. From time 0 on the triangles share no point before
// `lower`, which is infinity if they share none, and says nothing if it is 0. They share their first point at `upper`
// or before, which is infinity if it is not known if they share one. Holds in any rounding mode, with or without
// flush-to-zero or fused multiply-add. `pair` has the points at time 0.
Enclosure enclose_contact(const IntegerPair& pair, const ScaledVector& m, const ContactGuess& guess) noexcept;

}  // namespace ecods::exact
