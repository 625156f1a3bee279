// enclose_distance computes lower and upper bounds of the distance of two triangles, from one guessed pair of features.
#pragma once

#include <limits>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// An Enclosure holds a lower and an upper bound of a distance, or of a time of contact.
struct Enclosure {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
    // `is_certain` is true if the guessed features certainly contain the only two closest points in their relative
    // interiors; for a time of contact, the only point of the first contact.
    bool is_certain = false;
};

// Returns an interval that contains the distance, even if the guess is wrong. The interval is narrow if `features` are
// the closest ones. The bounds hold in any rounding mode, with or without flush-to-zero or fused multiply-add.
Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept;

// Returns the sign of n . (p - q), where p is corner 0 of the first triangle, and q a corner and n the normal of the
// second. It must be certain that p and the second triangle's face contain the only closest points.
int certain_side_of_face(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
