// Declares the questions of distance.hpp, and intersections(), about the surfaces of two bodies: all triangles of their
// meshes, whatever forms their shapes have.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/limits.hpp"
#include "ecods/ask.hpp"
#include "ecods/distance.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/number/exact_sum.hpp"

namespace ecods::surface {

using Body = Posed<MeshShape>;

// Throws InvalidArgument if a number of the tolerance is negative or NaN.
inline void require_valid(const DistanceTolerance& tolerance) {
    require_distance(tolerance.relative);
    require_distance(tolerance.absolute);
    require_distance(tolerance.max_distance);
}

// Returns true if certainly upper - lower <= max(absolute, relative * lower), or if the bounds are equal or adjacent
// doubles.
bool is_narrow(const DistanceBounds& bounds, const DistanceTolerance& tolerance);

double distance(const Body& a, const Body& b, const Ask& ask);
// Returns the distance minus the margin, rounded once; 0 if the margin is at least the distance.
double distance_beyond(const Body& a, const Body& b, const exact::ExactSum& margin, const Ask& ask);
// Returns the distance minus the margin, rounded once, also if it is negative. The margin may have either sign.
double signed_beyond(const Body& a, const Body& b, const exact::ExactSum& margin, const Ask& ask);
bool within(const Body& a, const Body& b, double max_distance, const Ask& ask);
bool within(const Body& a, const Body& b, const exact::Limit& limit, const Ask& ask);
ClosestPoints closest(const Body& a, const Body& b, const Ask& ask, const exact::Radii& radii = {});
// Returns the closest points of the rounded surfaces with their direction, and the distance minus the radii, also if
// this is negative; nullopt if the surfaces share a point.
std::optional<CloseFeatures> signed_closest(const Body& a, const Body& b, const Ask& ask, const exact::Radii& radii);
DistanceBounds distance_bounds(const Body& a, const Body& b, const DistanceTolerance& tolerance, const Ask& ask);
// Returns the pairs of triangles within d, which must be finite and not negative; nullopt if there are more than
// `most`.
std::optional<std::vector<TrianglePair>> pairs_within(const Body& a, const Body& b, double d, std::size_t most,
                                                      QueryMemory& memory);
std::vector<ClosestPoints> close_triangles(const Body& a, const Body& b, double max_distance, const Ask& ask);
std::vector<CloseFeatures> close_features(const Body& a, const Body& b, double max_distance, const Ask& ask);
std::vector<TriangleIntersection> intersections(const Body& a, const Body& b, const Ask& ask);

}  // namespace ecods::surface
