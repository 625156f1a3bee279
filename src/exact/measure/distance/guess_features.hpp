// Which features of two triangles are probably the closest.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/point/point.hpp"

namespace ecods::exact {

// Points 0 to 2 are the corners of the first triangle, 3 to 5 those of the second: integers of at most 62 bits, rounded
// or not. Nothing is promised about the guess, so no rounding matters. `vertex_edge` and `edge_edge` have edges of
// positive length, `vertex_face` a face with an area.
//
// After Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, 1999, section 6: all
// pairs of edges until the planes across the gap have both triangles on their outer sides, then corners over faces.
FeaturePair guess_features(const Points<6>& points) noexcept;

}  // namespace ecods::exact
