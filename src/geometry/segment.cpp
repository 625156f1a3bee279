#include "ecods/segment.hpp"

#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Segment& segment) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(segment.a[axis])) throw InvalidSegment(0, axis, segment.a[axis]);
        if (!is_finite(segment.b[axis])) throw InvalidSegment(1, axis, segment.b[axis]);
    }
}

}  // namespace ecods
