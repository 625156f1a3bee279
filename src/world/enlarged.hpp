// Enlarges boxes, so that the boxes of two bodies within a given distance overlap.
#pragma once

#include "base/next.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Returns the box, enlarged on all sides by at least half the distance d >= 0. The enlarged boxes of two bodies within
// d of each other overlap. Proof: let p be a point of a and q a point of b within d, and p <= q on an axis. Then q - p
// <= d, so the enlarged box of a reaches up to p + d / 2 at least, and the enlarged box of b down to q - d / 2 <= p + d
// / 2 at least.
//
// Each operation is off by at most one unit in its last place, in any rounding mode; next_up and next_down make up for
// this error. If the processor flushes subnormal numbers to zero, half the distance is off by at most 2^-1022, an end
// of the box by 2^-1022, and their sum by 2^-1022; the addend 2^-1020 exceeds all three together. An infinite end stays
// infinite, and an infinite distance makes every end infinite.
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
