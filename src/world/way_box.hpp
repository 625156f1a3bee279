// Computes boxes that contain a body of a world during its whole motion.
#pragma once

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "world/world_impl.hpp"

namespace ecods {

// Returns a box that contains every point of a body while it moves from `start` on, where the box `from` contains it.
// Throws InvalidArgument if the caller's own shape returns a bad box at another pose.
Aabb box_of_way(const Shape& shape, const Pose& start, const Aabb& from, const Motion& motion, BodyId body = {},
                const ListIndex& index = {});

}  // namespace ecods
