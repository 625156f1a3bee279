#include "ecods/ball.hpp"

#include <limits>

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {

// By keys, in whose order a NaN lies beyond the infinities.
void validate(const Ball& ball) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_finite(ball.center[axis])) throw InvalidBall(axis, ball.center[axis]);
    }
    const auto key = key_of(ball.radius);
    if (key < 0 || key > key_of(std::numeric_limits<double>::infinity())) throw InvalidBall(3, ball.radius);
}

}  // namespace ecods
