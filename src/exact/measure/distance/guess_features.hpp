// guess_features() guesses the features of two triangles that contain the closest points.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// Returns probable closest features of two triangles. The guess may be wrong, so rounding does not matter. An edge of a
// guess has a positive length if the kind is `vertex_edge` or `edge_edge`, and the face of `vertex_face` has an area.
//
// The method is that of Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, 1999,
// section 6, but tries faces first: corners over faces, and then pairs of edges. The search stops at the first pair of
// edges or of corner and face for which the planes through its two closest points, perpendicular to the gap, have the
// triangles on their outer sides.
FeaturePair guess_features(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
