// What lists of many pairs of convex solids ask of each: no more is found out of a pair that is not in the list.
#pragma once

#include <optional>

#include "ecods/convex_solid.hpp"

namespace ecods::convex {

// The distance, rounded once, if the real one is at most the limit. Throws SingularPose. limit >= 0, or infinity.
std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory);

// Whether the sets share a point. Throws SingularPose.
bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

}  // namespace ecods::convex
