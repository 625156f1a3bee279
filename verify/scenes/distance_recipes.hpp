// Recipes behind some families of distance_cases.hpp, which says what each makes.
#pragma once

#include <array>

#include "scenes/distance_cases.hpp"

namespace ecods::scenes::closeness {

using Corners = std::array<Vec3, 3>;

// With known distances.
DistanceCase parallel_faces(Random& random);
DistanceCase lattice_features(Random& random);
DistanceCase half_way(Random& random);

}  // namespace ecods::scenes::closeness
