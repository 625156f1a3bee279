// find_inner_balls() computes a lower bound of the depth of two solids from balls inside the solids.
#pragma once

#include <optional>

#include "ecods/solid.hpp"

namespace ecods::depths {

// A BallHint says where a second search begins: around `middle`, with steps of length `step`.
struct BallHint {
    Vec3 middle;
    double step;
};

// Returns the largest r + s found, rounded down, such that balls of radii r and s around one point are inside the first
// and the second solid; 0 if no point inside both solids was found. The result is a lower bound of the depth: after a
// translation shorter than r + s the two balls still share inner points, and so do the solids.
double find_inner_balls(const Posed<Solid>& a, const Posed<Solid>& b, const std::optional<BallHint>& hint,
                        QueryMemory& memory);

}  // namespace ecods::depths
