// Which features of two triangles are probably the closest.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/integer_pair.hpp"

namespace ecods::exact {

// Nothing is promised about the guess, so no rounding matters. `vertex_edge` and `edge_edge` have edges of positive
// length, `vertex_face` a face with an area.
//
// After Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, 1999, section 6: all
// pairs of edges until the planes across the gap have both triangles on their outer sides, then corners over faces.
FeaturePair guess_features(const IntegerPair& pair) noexcept;

}  // namespace ecods::exact
