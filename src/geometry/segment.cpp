#include "ecods/segment.hpp"

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Segment& segment) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(segment.a[axis])) throw InvalidSegment(0, axis, segment.a[axis]);
        if (!is_finite(segment.b[axis])) throw InvalidSegment(1, axis, segment.b[axis]);
    }
}

void validate(const Ray& ray) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ray.origin[axis])) throw InvalidRay(InvalidRay::Part::origin, axis, ray.origin[axis]);
        if (!is_finite(ray.direction[axis])) throw InvalidRay(InvalidRay::Part::direction, axis, ray.direction[axis]);
    }
    // By bits: where subnormal numbers are taken for zero, a direction of them still is one.
    if (key_of(ray.direction[0]) == 0 && key_of(ray.direction[1]) == 0 && key_of(ray.direction[2]) == 0) {
        throw InvalidRay(InvalidRay::Part::direction, 0, 0);
    }
    if (!is_from_zero(ray.parameter_max)) throw InvalidRay(InvalidRay::Part::parameter_max, 0, ray.parameter_max);
}

}  // namespace ecods
