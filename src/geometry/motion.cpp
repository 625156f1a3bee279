#include "ecods/motion.hpp"

#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate_motion(const Vec3& motion) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(motion[axis])) throw InvalidMotion(axis, motion[axis]);
    }
}

}  // namespace ecods
