// A lower bound of how deep two solids are in each other, from balls inside them.
#pragma once

#include <optional>

#include "ecods/solid.hpp"

namespace ecods::depths {

// Let balls around one point, with radii r and s, be inside the two solids. A translation that is shorter than r + s
// leaves them meeting, and so the solids' interiors. Returns the largest r + s found, rounded down; 0 if no point
// inside both was.
//
// The search begins around `middle`, too, by steps of that length, where it is given.
struct BallHint {
    Vec3 middle;
    double step;
};
double find_inner_balls(const Posed<Solid>& a, const Posed<Solid>& b, const std::optional<BallHint>& hint,
                        QueryMemory& memory);

}  // namespace ecods::depths
