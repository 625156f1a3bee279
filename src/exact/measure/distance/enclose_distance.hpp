// Two numbers between which the distance of two triangles is, from one guessed pair of features.
#pragma once

#include <limits>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// A lower and an upper bound of a distance, or of a time.
struct Enclosure {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
    // The features certainly hold the only points that are closest, or shared first, each in its relative interior.
    bool is_certain = false;
};

// Whatever the features are, the interval contains the distance; it is narrow if they are the closest. In any rounding
// mode, with or without flush-to-zero or fused multiply-add.
Enclosure enclose_distance(const IntegerPair& pair, const FeaturePair& features) noexcept;

}  // namespace ecods::exact
