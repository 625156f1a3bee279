// fixed_distance rounds the distance of two features, in integers of fixed width.
#pragma once

#include <optional>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// Returns the distance of the features, rounded once; a positive distance to at least 2^-1074. Returns nullopt if the
// rounding is not certain, about once in 2^30 distances, or if points that are not exact leave a sign open; then exact
// fractions are rounded (squared_distance.hpp). The features must have exactly one pair of closest points, in their
// relative interiors. Only the features' own corners in `pair` are read.
std::optional<double> fixed_distance(const IntegerPair& pair, const FeaturePair& features) noexcept;

}  // namespace ecods::exact
