// round_root_sum rounds the sum of a rational number and a square root once.
#pragma once

#include "exact/number/root_sum.hpp"

namespace ecods::exact {

// Returns the double nearest to the sum, ties to even; infinity if it is beyond the largest double; a zero is +0. The
// floating-point environment has no effect.
double round_root_sum(const RootSum& sum);

// Returns the double nearest to the sum, but at least 2^-1074 in magnitude unless the sum is 0.
double round_signed(const RootSum& sum);

// Returns round_signed(), or 0 if the sum is not positive.
double round_positive_part(const RootSum& sum);

}  // namespace ecods::exact
