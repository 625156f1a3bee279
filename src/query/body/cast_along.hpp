// cast_along casts a body along the nodes of a way, each leg in an equal share of the time (motion.hpp).
#pragma once

#include <optional>
#include <span>

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Returns the first contact with b, which stays; nullopt if its time is above max_time. The nodes must be valid. Throws
// the errors of a cast of a Way, for the legs that begin by max_time, and that of a bad max_time.
std::optional<FirstContact> cast_along(const Posed<MeshShape>& a, std::span<const WayNode> nodes,
                                       const Posed<MeshShape>& b, double max_time, const Ask& ask);

}  // namespace ecods
