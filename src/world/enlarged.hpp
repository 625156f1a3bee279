// Boxes that reach further, so that those of bodies within a distance overlap.
#pragma once

#include "base/next.hpp"
#include "ecods/aabb.hpp"

namespace ecods {

// The box, enlarged on all sides by at least half the distance, which is not negative: boxes of bodies that are within
// it overlap. For where p of a and q of b are within d, q - p <= d on each axis, and p + d / 2 and q - d / 2 are in
// what is enlarged by at least d / 2.
//
// With an operation off by one unit in its last place, in any rounding mode, next_up makes up for that. Subnormal
// numbers may be taken for zero: half the distance by at most 2^-1022, an end of the box by 2^-1022, and their sum by
// 2^-1022, which 2^-1020 exceeds. An end at infinity stays there, and an infinite distance reaches there.
inline Aabb enlarged(const Aabb& box, double distance) noexcept {
    const double half = next_up(0.5 * distance + 0x1p-1020);
    Aabb result;
    for (int axis = 0; axis < 3; ++axis) {
        result.min[axis] = next_down(box.min[axis] - half);
        result.max[axis] = next_up(box.max[axis] + half);
    }
    return result;
}

}  // namespace ecods
