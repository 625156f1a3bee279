// Finds a lower bound of the depth of two solids, from balls inside them.
#pragma once

#include <optional>

#include "ecods/solid.hpp"

namespace ecods::depths {

// A place where a search begins, in addition to its own: around `middle`, by steps of length `step`.
struct BallHint {
    Vec3 middle;
    double step;
};

// Let balls around one point, with radii r and s, be inside the two solids. A translation shorter than r + s leaves the
// balls meeting, and so the solids' interiors. Returns the largest r + s found, rounded down; 0 if no point inside both
// solids was found.
double find_inner_balls(const Posed<Solid>& a, const Posed<Solid>& b, const std::optional<BallHint>& hint,
                        QueryMemory& memory);

}  // namespace ecods::depths
