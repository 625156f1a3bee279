// MotionKinds checks that a cast exists for the kinds of two bodies' motions (cast_any_motion.cpp). The functions below
// classify a motion.
#pragma once

#include <cstddef>
#include <vector>

#include "ecods/pose.hpp"

namespace ecods {

class MotionKinds {
  public:
    // Adds the motion of a body that is at the pose `start` at time 0. A body at rest adds no kind of motion.
    void add(const Pose& start, const Motion& motion);

    // Throws NotSupported if there is no cast of some two of the bodies added.
    void require_casts() const;

  private:
    std::size_t moving_count_ = 0, way_count_ = 0;
};

// Returns the nodes of a body that goes along a way; null for other motions, and for nodes that are a Turn.
const std::vector<WayNode>* nodes_of(const Motion& motion);

// Returns the last pose of a body that is at rest (&start) or goes straight to a pose; null for other motions.
// Both arguments must outlive the result.
const Pose* straight_end(const Pose& start, const Motion& motion);

// Returns a turn that moves every body as the motion does: a translation is a turn by the angle 0. Call only for
// translations, turns, and nodes that are a Turn.
Turn turn_of(const Motion& motion);

}  // namespace ecods
