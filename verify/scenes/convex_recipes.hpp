// Recipes behind families of convex_cases.hpp: those whose numbers are known, and flat sets.
#pragma once

#include "scenes/convex_cases.hpp"

namespace ecods::scenes::convexity {

ConvexCase aligned_boxes(Random& random);
ConvexCase integer_rotations(Random& random);
ConvexCase flat_sets(Random& random);

}  // namespace ecods::scenes::convexity
