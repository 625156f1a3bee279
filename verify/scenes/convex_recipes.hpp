// Recipes behind the families of convex_cases.hpp whose numbers are known.
#pragma once

#include "scenes/convex_cases.hpp"

namespace ecods::scenes::convexity {

ConvexCase aligned_boxes(Random& random);
ConvexCase integer_rotations(Random& random);

}  // namespace ecods::scenes::convexity
