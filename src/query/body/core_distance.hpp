// Declares the functions of distance.hpp for two rounded bodies. A rounded body is the set of all points within a
// radius of its core; with radius 0, the body is the core.
#pragma once

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/number/exact_sum.hpp"

namespace ecods::cores {

using Core = Posed<MeshShape>;

// Returns true if the real distance of the cores is within the limit.
bool within(const Core& a, const Core& b, const exact::Limit& limit, const Ask& ask);

// Returns the distance of the cores minus the margin, rounded once; 0 if the margin is at least the distance.
double distance(const Core& a, const Core& b, const exact::ExactSum& margin, const Ask& ask);

// Returns the distance and the closest points of the rounded bodies, and the features of the cores.
ClosestPoints closest(const Core& a, const Core& b, const exact::Radii& radii, const Ask& ask);

}  // namespace ecods::cores
