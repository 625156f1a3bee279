// Gives a world settings that callers do not have.
#pragma once

#include <vector>

#include "ecods/world.hpp"

namespace ecods {

struct WorldAccess {
    // Takes solids for their surfaces in every question and list, but for solid_pairs of version 1 of traces, which are
    // then the world's relations(). Call it before the world has a body.
    static void take_solids_for_surfaces(World& world);

    static std::vector<PairDistance> unsigned_distances(const World& world, double max_distance);
};

// Returns the distances of pairs of convex solids within max_distance, which are 0 where they share a point. Throws
// SingularPose if any convex solid has a singular pose. For traces.
inline std::vector<PairDistance> unsigned_distances(const World& world, double max_distance) {
    return WorldAccess::unsigned_distances(world, max_distance);
}

}  // namespace ecods
