// guess_features guesses which features of two triangles contain the closest points.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// The guess may be wrong, so rounding does not matter. An edge of a guess has a positive length if the kind is
// `vertex_edge` or `edge_edge`, and the face of `vertex_face` has an area.
//
// Follows Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, 1999, section 6, but
// tries faces first: corners over faces, and then pairs of edges. It stops at the first pair whose two closest points
// have the triangles on the outer sides of the planes through them, perpendicular to the gap.
FeaturePair guess_features(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
