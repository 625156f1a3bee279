// straight_end() and turn_of() say of which kind a motion is.
#pragma once

#include "ecods/motion.hpp"

namespace ecods {

// Returns the last pose of a body that is at rest (&start) or goes straight to a pose; null for other motions.
// Both arguments must outlive the result.
const Pose* straight_end(const Pose& start, const Motion& motion);

// Returns a turn that moves every body as the motion does: a translation is a turn by the angle 0. Call only for
// translations and turns.
Turn turn_of(const Motion& motion);

}  // namespace ecods
