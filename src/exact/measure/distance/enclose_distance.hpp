// enclose_distance bounds the distance of two triangles from below and above, from one guessed pair of features.
#pragma once

#include <limits>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// Holds a lower and an upper bound of a distance, or of a time.
struct Enclosure {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
    // True if the features certainly hold the only points that are closest, or shared first, each in its relative
    // interior.
    bool is_certain = false;
};

// Returns an interval that contains the distance whatever the features are, and is narrow if they are the closest.
// Holds in any rounding mode, with or without flush-to-zero or fused multiply-add.
Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept;

}  // namespace ecods::exact
