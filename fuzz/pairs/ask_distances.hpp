// The exact layer's answers about the distances of single pairs of triangles.
#pragma once

#include <optional>

#include "judge/distance_truth.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Asks everything that TriangleDistances answers about some pairs of triangles, in both orders of bodies.
std::optional<judge::Wrong> ask_triangles(const scenes::DistanceCase& made, scenes::Random& random);

}  // namespace ecods::fuzz
