// A Motion says how a body moves in the time from 0 to 1: it is translated, or goes straight to another pose, or turns,
// or goes along the nodes of a way. Two bodies may have any two of the first three motions; beside a body that goes
// along a way, the other one stays (turn.hpp, world.hpp). (FCL: MotionBase; Parry: NonlinearRigidMotion; Box3D:
// b3Sweep.)
//
// Example: verify/examples/how_do_i, move_at_once().
#pragma once

#include <span>
#include <variant>
#include <vector>

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

// A WayNode is a node of a way (way.hpp): the quaternion of the turn since the beginning, and the place of the pivot.
struct WayNode {
    Quaternion q;
    Vec3 pivot = Vec3::Zero();

    friend bool operator==(const WayNode& a, const WayNode& b) { return a.q == b.q && a.pivot == b.pivot; }
};

// Moves a body along a way (way.hpp), each leg in an equal share of the time: of n legs, leg k (from 0) takes the time
// from k / n to (k + 1) / n. A contact on leg k, at the time s of the leg, which cast(Way, Posed) returns as a double,
// is at the time (k + s) / n, rounded once; the contact counts if this time is at most max_time. So the time is 0
// exactly if the bodies share a point at the start. Divide legs that should take longer; ask cast(Way, Posed) for the
// leg itself.
//
// A body on a way meets bodies at rest. Casts and meetings of it beside a body that moves throw NotSupported: where a
// leg begins, the other one is at no pose of doubles. There is one exception: two nodes, of which the first has the
// quaternion 1 (without a factor), are treated as a Turn everywhere. A cast searches every leg that begins by max_time.
struct Along {
    std::vector<WayNode> nodes;

    friend bool operator==(const Along&, const Along&) = default;
};

// A Motion is the motion of one body; Motion() is that of a body at rest. Turn and Along keep the body rigid
// (turn.hpp).
using Motion = std::variant<Translation, Straight, Turn, Along>;

// Throws InvalidArgument if a number is not finite (Argument::motion for a translation, pose, turn), and the other
// errors of validate() for a turn or nodes.
ECODS_API void validate(const Motion& motion);

// Throws InvalidArgument (Argument::turn), whose index is that of the node: if a number is not finite ("q.w", "q.x",
// "pivot(0)"); if a quaternion is zero, or a negative multiple of the one before it, which would be a whole turn about
// no axis ("q"); if the first node's quaternion is not a positive number ("q"); or, without an index, if there are
// fewer than two nodes ("nodes").
ECODS_API void validate(std::span<const WayNode> nodes);

}  // namespace ecods
