// Motions of whole scenes that go on for some frames, as the workloads of bench's suite broad: what a broad phase keeps
// from frame to frame is asked for in these, while it keeps nothing of boxes that jump.
#pragma once

#include <cstdint>

#include "fuzz/motion/changes.hpp"

namespace ecods::fuzz {

// The next frame of the motion that the scene is in; another follows after some frames.
void calm_motion(Writing& w);

// Where the i-th body is at first: some are large and flat, and others lie in clusters beside one.
Pose calm_pose(const Setting& setting, const Model& model, std::uint32_t i, scenes::Random& random);

}  // namespace ecods::fuzz
