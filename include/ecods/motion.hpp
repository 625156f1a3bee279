// A Motion says how a body moves in the time from 0 to 1: it is translated, or goes straight to another pose, or turns.
// (FCL: MotionBase; Parry: NonlinearRigidMotion; Box3D: b3Sweep.)
// Two bodies may move in any two of these ways (turn.hpp, world.hpp).
//
// Example: verify/examples/how_do_i, move_at_once().
#pragma once

#include <variant>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"

namespace ecods {

// Translates a body by time times `by`, by default not at all.
struct Translation {
    Vec3 by = Vec3::Zero();

    friend bool operator==(const Translation& a, const Translation& b) { return a.by == b.by; }
};

// Moves each point of a body on a straight line, at constant speed, to its place at the pose `to`. Such a motion is no
// rotation (cast.hpp).
struct Straight {
    Pose to;

    friend bool operator==(const Straight&, const Straight&) = default;
};

// A Motion is the motion of one body; Motion() is that of a body at rest. A Turn keeps the body rigid (turn.hpp).
using Motion = std::variant<Translation, Straight, Turn>;

// Throws InvalidArgument if a number is not finite (Argument::motion for a translation, pose, turn), and the other
// errors of validate() for a turn.
ECODS_API void validate(const Motion& motion);

}  // namespace ecods
