// Declares casts of two bodies: one goes straight to a pose, and the other one moves in another way.
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "query/cast/straight_move.hpp"

namespace ecods {

// The casts return the first contact of a and b up to max_time, as the casts of cast.hpp and turn.hpp do. Turn and
// poses must be valid.
std::optional<FirstContact> cast(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double max_time,
                                 const Ask& ask);
std::optional<FirstContact> cast(const StraightMove& a, const StraightMove& b, double max_time, const Ask& ask);

}  // namespace ecods
