// The functions of this file compare exact distances with exact sums, and round the differences once. The distance of
// two rounded bodies is the distance of their cores minus the sum of their radii.
#pragma once

#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/exact_sum.hpp"

namespace ecods::exact {

// Returns the sign of distance - sum. The sum must not be negative.
int compare(const SquaredDistance& square, const ExactSum& sum);

// Returns the double nearest to distance - margin, ties to even; 0 if the difference is not positive, otherwise at
// least 2^-1074; infinity above the largest double.
double round_beyond(const SquaredDistance& square, const ExactSum& margin);

// Returns the double nearest to distance - margin, ties to even, for a margin of either sign; at least 2^-1074 in
// magnitude unless the difference is 0.
double round_signed_beyond(const SquaredDistance& square, const ExactSum& margin);

}  // namespace ecods::exact
