// distance_below is a lower bound of the distance of two boxes; it is used to leave boxes out, and decides nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "ecods/primitives.hpp"

namespace ecods {

// Returns a lower bound of the distance of two closed boxes, in every floating-point environment; infinity only if the
// distance exceeds the largest double. The bound of boxes that contain these is no greater.
//
// With u' = 2^-52, which bounds an operation in any rounding mode, a gap has a relative error of u', its square of 3.01
// u', the sum of three of 5.02 u', the root of 3.52 u' and the product at the end of 4.53 u'; the factor takes off 16
// u'. Gaps below 2^-500 count as none and gaps above 2^500 as 2^500, so that no square overflows or is subnormal; ends
// that were flushed to zero are off by 2^-1022, which is 2^-522 of a gap that counts there. The largest gap alone is a
// bound at any scale: it may be as small as 2^-960, of which 2^-1022 is 2^-62. All steps are monotone, so boxes within
// these have no smaller bound.
// Claim: verify/proofs/small_bounds.py
inline double distance_below(const Aabb& a, const Aabb& b) noexcept {
    constexpr double factor = 1 - 0x1p-48, gap_min = 0x1p-500, gap_max = 0x1p500, largest_min = 0x1p-960;
    double largest = 0, sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // Infinite ends may give NaN, which is no gap.
        const double gap = std::max(a.min[axis] - b.max[axis], b.min[axis] - a.max[axis]);
        if (!(gap >= largest_min)) continue;
        largest = std::max(largest, gap);
        const double counted = std::min(gap, gap_max);
        if (counted >= gap_min) sum += counted * counted;
    }
    return factor * std::max(largest, std::sqrt(sum));
}

}  // namespace ecods
