// distance_below returns a lower bound of the distance of two boxes. The bound serves to leave out boxes that are too
// far away; no answer follows from it alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/next.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Returns the gap of two boxes on an axis. The gap is negative if the boxes overlap on this axis.
inline double gap_on(int axis, const Aabb& a, const Aabb& b) noexcept {
    return std::max(a.min[axis] - b.max[axis], b.min[axis] - a.max[axis]);
}

// Returns a lower bound of the distance of two closed boxes, in every floating-point environment; infinity only if the
// distance exceeds the largest double. Larger boxes that contain a and b never get a greater bound than a and b.
//
// Let u' = 2^-52, which bounds the relative error of one operation in any rounding mode. A gap has a relative error of
// u', its square of 3.01 u', the sum of three squares of 5.02 u', the root of 3.52 u' and the product at the end of
// 4.53 u'. The factor 1 - 2^-48 subtracts 16 u'. In the sum, gaps below 2^-500 count as 0 and gaps above 2^500 as
// 2^500, so no square overflows or is subnormal. An end that is flushed to zero changes by at most 2^-1022, which is
// 2^-522 of a gap of 2^-500. The largest gap alone is a lower bound, too, at any scale. The largest gap counts only
// from 2^-960 on, so 2^-1022 is at most 2^-62 of it. All steps are monotone, so boxes that contain a and b get no
// greater bound.
// Claim: verify/proofs/small_bounds.py
inline double distance_below(const Aabb& a, const Aabb& b) noexcept {
    constexpr double factor = 1 - 0x1p-48, gap_min = 0x1p-500, gap_max = 0x1p500, largest_min = 0x1p-960;
    double largest = 0, sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // Infinite ends may give NaN, which fails the comparison, so it counts as no gap.
        const double gap = gap_on(axis, a, b);
        if (!(gap >= largest_min)) continue;
        largest = std::max(largest, gap);
        const double counted = std::min(gap, gap_max);
        if (counted >= gap_min) sum += counted * counted;
    }
    return factor * std::max(largest, std::sqrt(sum));
}

// Returns a lower bound of the signed distance of two sets in these boxes. The signed distance of two sets that meet is
// minus the length of the shortest translation that parts them. The bound is distance_below() if that is positive.
// Otherwise it is minus the length of the shortest translation along an axis that parts the boxes.
//
// This length is rounded up. Each end that is flushed to zero changes it by less than 2^-1022, and so does a flushed
// difference: the subtrahend 2^-1020 covers these. The subtraction of the ends rounds by less than one unit in the last
// place, in any rounding mode, which the first next_down covers. The second next_down covers the rounding when 2^-1020
// is subtracted. If 2^-1020 is too small to change the number, the number's unit in the last place is greater.
inline double signed_distance_below(const Aabb& a, const Aabb& b) noexcept {
    const double apart = distance_below(a, b);
    if (apart > 0) return apart;
    double largest = -std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = gap_on(axis, a, b);
        if (gap > largest) largest = gap;  // not if it is NaN
    }
    return std::min(next_down(next_down(largest) - 0x1p-1020), 0.0);
}

}  // namespace ecods
