// Declares the signed distance of two convex solids with radii around them.
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/round/rounded_ends.hpp"

namespace ecods::depths {

// Returns the distance of the solids minus the radii; if the solids share a point, minus the sum of their depth and the
// radii. The points are those of the rounded solids. The call is counted as a question. Throws SingularPose.
SignedDistance signed_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::Radii& radii,
                               const Ask& ask);

// Returns signed_distance() if the solids share a point; otherwise nullopt.
std::optional<SignedDistance> signed_depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                           const exact::Radii& radii, const Ask& ask);

}  // namespace ecods::depths
