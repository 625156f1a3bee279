// Pairs of posed convex solids on which distances and depths go wrong, by family; of some the numbers follow from how
// they are made.
// The table of convex_cases.cpp says what each family makes.
#pragma once

#include <optional>

#include "scenes/families.hpp"
#include "scenes/lattice_mesh.hpp"

namespace ecods::scenes {

struct ConvexCase {
    PosedMesh a, b;
    // Where the recipe knows them: one of the two, or both as 0 where they touch.
    std::optional<double> distance = {};
    std::optional<double> depth = {};
};

Families<ConvexCase> convex_families();

// Moves b, in doubles, so that a vertex of one is above the middle of a triangle of the other by `gap`, or the middles
// of two edges are so far apart; into the other solid where it is negative.
void bring_near(ConvexCase& made, double gap, Random& random);

}  // namespace ecods::scenes
