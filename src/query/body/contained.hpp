// Decides if a part of one body is inside another one, which questions about surfaces do not see.
//
// Sets A and B that share a point, though their boundaries share none, contain each other in parts: a common point is
// inside B, say, or on the boundary of B and inside A. A piece of the boundary of A that shares no point with that of B
// is on one side of it, so one vertex of the piece says on which. If no piece of either boundary is inside the other
// set, no point is common: a point inside both could be moved along a line until it meets one of the boundaries, and
// the first one that it meets has a piece inside the other set.
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/results.hpp"
#include "query/body/posed_body.hpp"

namespace ecods {

// True if a vertex of a piece of one body is in the other body, which has an inside. If it is false and the boundaries
// share no point, the bodies share none. Counts as part of another question.
// Cost: two boxes, and a ray for each piece of which a vertex is in the other's box. Of many pieces, most of those that
// are outside need none (OutsideBall).
bool is_part_inside(const BodyPairAsked& bodies, QueryMemory& memory);

// The features that ClosestPoints names for contained bodies: a vertex of one body, and none of the other one.
struct ContainedFeatures {
    Feature a = no_feature, b = no_feature;

    bool is_of_a() const noexcept { return a.kind != Feature::Kind::none; }
};

// Returns these features if the bodies share a point and their boundaries share none; otherwise nullopt.
std::optional<ContainedFeatures> find_contained(const BodyPairAsked& bodies, QueryMemory& memory);

}  // namespace ecods
