// Arguments of public functions are checked before use. The errors name the first coordinate that is bad.
#include <array>
#include <limits>
#include <string>
#include <utility>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

namespace {

// Returns true if min <= max and neither is NaN. Compares keys: comparisons of doubles may take subnormal numbers for
// zero. The key of NaN is beyond the keys of the infinities.
bool is_interval(double min, double max) noexcept {
    constexpr std::int64_t most = key_of(std::numeric_limits<double>::infinity());
    return -most <= key_of(min) && key_of(min) <= key_of(max) && key_of(max) <= most;
}

}  // namespace

void validate(const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_interval(box.min[axis], box.max[axis])) throw invalid_box(axis, box.min[axis], box.max[axis]);
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

void validate(const Turn& turn) {
    const Quaternion& q = turn.q;
    const std::array<std::pair<const char*, double>, 4> components{
        {{"q.w", q.w}, {"q.x", q.x}, {"q.y", q.y}, {"q.z", q.z}}};
    for (const auto& [name, value] : components) {
        if (!is_finite(value)) throw invalid_turn(name, value);
    }
    for (const auto& [name, pivot] :
         {std::pair("pivot_from", &turn.pivot_from), std::pair("pivot_to", &turn.pivot_to)}) {
        for (int axis = 0; axis < 3; ++axis) {
            if (is_finite((*pivot)[axis])) continue;
            throw invalid_turn(std::string(name) + "(" + std::to_string(axis) + ")", (*pivot)[axis]);
        }
    }
    if (key_of(q.w) <= 0 && key_of(q.x) == 0 && key_of(q.y) == 0 && key_of(q.z) == 0) throw whole_turn(q.w);
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
    if (is_zero(ray.direction)) throw no_direction();
    if (!is_from_zero(ray.max_parameter)) throw invalid_max_parameter(ray.max_parameter);
}

void refuse_null_thing() {
    throw null_argument("thing to be posed");
}

}  // namespace ecods
