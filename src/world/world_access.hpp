// Gives a world settings that callers do not have.
#pragma once

#include "ecods/world.hpp"

namespace ecods {

struct WorldAccess {
    // Takes solids for their surfaces in every question and list, but for solid_pairs of version 1 of traces, which are
    // then the world's relations(). Call it before the world has a body.
    static void take_solids_for_surfaces(World& world);
};

}  // namespace ecods
