// What callers give is checked before it is used: typed errors name the first coordinate that is bad.
#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/aabb.hpp"
#include "ecods/ball.hpp"
#include "ecods/motion.hpp"
#include "ecods/segment.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis])) throw invalid_box(axis, box.min[axis], box.max[axis]);
    }
}

void validate(const Ball& ball) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ball.center[axis])) throw invalid_center(axis, ball.center[axis]);
    }
    if (!is_from_zero(ball.radius)) throw invalid_radius(ball.radius);
}

void validate_motion(const Vec3& motion) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(motion[axis])) throw invalid_motion(axis, motion[axis]);
    }
}

void validate(const Segment& segment) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(segment.a[axis])) throw invalid_segment(0, axis, segment.a[axis]);
        if (!is_finite(segment.b[axis])) throw invalid_segment(1, axis, segment.b[axis]);
    }
}

void validate(const Ray& ray) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ray.origin[axis])) throw invalid_origin(axis, ray.origin[axis]);
        if (!is_finite(ray.direction[axis])) throw invalid_direction(axis, ray.direction[axis]);
    }
    // By bits: where subnormal numbers are taken for zero, a direction of them still is one.
    if (key_of(ray.direction[0]) == 0 && key_of(ray.direction[1]) == 0 && key_of(ray.direction[2]) == 0) {
        throw no_direction();
    }
    if (!is_from_zero(ray.parameter_max)) throw invalid_max_parameter(ray.parameter_max);
}

}  // namespace ecods
