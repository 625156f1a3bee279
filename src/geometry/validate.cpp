// Callers' arguments are checked before they are used: typed errors name the first coordinate that is bad.
#include "base/double_key.hpp"
#include "ecods/ball.hpp"
#include "ecods/error.hpp"
#include "ecods/motion.hpp"
#include "ecods/segment.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(axis, box.min[axis], box.max[axis]);
    }
}

void validate(const Ball& ball) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ball.center[axis])) throw InvalidBall(axis, ball.center[axis]);
    }
    if (!is_from_zero(ball.radius)) throw InvalidBall(3, ball.radius);
}

void validate_motion(const Vec3& motion) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(motion[axis])) throw InvalidMotion(axis, motion[axis]);
    }
}

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
    // Compares bits: if subnormal numbers are taken for zero, a direction of subnormal numbers is still a direction.
    if (key_of(ray.direction[0]) == 0 && key_of(ray.direction[1]) == 0 && key_of(ray.direction[2]) == 0) {
        throw InvalidRay(InvalidRay::Part::direction, 0, 0);
    }
    if (!is_from_zero(ray.parameter_max)) throw InvalidRay(InvalidRay::Part::parameter_max, 0, ray.parameter_max);
}

}  // namespace ecods
