#include "ecods/ball.hpp"

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

void validate(const Ball& ball) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ball.center[axis])) throw InvalidBall(axis, ball.center[axis]);
    }
    if (!is_from_zero(ball.radius)) throw InvalidBall(3, ball.radius);
}

}  // namespace ecods
