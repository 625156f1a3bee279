// Gives replayed worlds settings that callers do not have.
#pragma once

#include <vector>

#include "ecods/world.hpp"

namespace ecods {

struct WorldAccess {
    // Treats solids as their surfaces in every question and list. The only exception is relations(), which then is the
    // list solid_pairs of version 1 of traces. Call it before the world has a body.
    static void take_solids_for_surfaces(World& world);

    static std::vector<PairDistance> unsigned_distances(const World& world, double max_distance);
};

// Returns the distances of pairs of convex solids within max_distance; the distance of two that share a point is 0.
// Throws SingularPose if any convex solid has a singular pose. Used for traces of version 1.
inline std::vector<PairDistance> unsigned_distances(const World& world, double max_distance) {
    return WorldAccess::unsigned_distances(world, max_distance);
}

}  // namespace ecods
