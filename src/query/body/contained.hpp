// Decides whether a part of one body is inside another one: a fact that questions about surfaces leave open.
//
// Suppose that sets A and B share a point, and that their boundaries share none. Then a piece of one boundary is inside
// the other set. Proof: a common point is inside B, say, or on the boundary of B and inside A. A point inside both
// could be moved along a line until it meets one of the boundaries, and the first boundary that it meets has a piece
// inside the other set. A piece of the boundary of A that shares no point with the boundary of B is on one side of it,
// so one vertex of the piece shows on which.
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/results.hpp"
#include "query/body/posed_body.hpp"

namespace ecods {

// Returns true if a vertex of a piece of one body is in the other body, which has an inside. If the result is false and
// the boundaries share no point, the bodies share none. The work is counted as part of the question that calls this
// function. Cost: two boxes, and a ray for each piece that has a vertex in the other body's box. If there are many
// pieces, most pieces outside need no ray (OutsideBall).
bool is_part_inside(const BodyPairAsked& bodies, QueryMemory& memory);

// ContainedFeatures are the features that ClosestPoints names for contained bodies: a vertex of one body, and no
// feature of the other one.
struct ContainedFeatures {
    Feature a = no_feature, b = no_feature;

    bool is_of_a() const noexcept { return a.kind != Feature::Kind::none; }
};

// Returns the features if the bodies share a point and their boundaries share none; otherwise nullopt.
std::optional<ContainedFeatures> find_contained(const BodyPairAsked& bodies, QueryMemory& memory);

}  // namespace ecods
