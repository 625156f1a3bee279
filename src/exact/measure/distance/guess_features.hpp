// guess_features guesses which features of two triangles are the closest.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// Promises nothing about the guess, so rounding does not matter. `vertex_edge` and `edge_edge` have edges of positive
// length, `vertex_face` a face with an area.
//
// Follows Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, 1999, section 6, with
// faces first: tries corners over faces, then all pairs of edges until the planes across the gap have both triangles on
// their outer sides.
FeaturePair guess_features(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
