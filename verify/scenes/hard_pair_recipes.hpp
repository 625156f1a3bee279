// The recipes behind the families of hard_pairs.hpp, which says what each makes.
#pragma once

#include "scenes/hard_pairs.hpp"

namespace ecods::scenes::hard {

PosedPair lattice(Random& random);
PosedPair generic(Random& random);
PosedPair coplanar(Random& random);
PosedPair edge_on_edge(Random& random);
PosedPair permutations(Random& random);
PosedPair short_coordinates(Random& random);
PosedPair far_from_origin(Random& random);
PosedPair slivers(Random& random);
PosedPair wide_exponents(Random& random);
PosedPair scaled(Random& random, int exponent_min, int exponent_max);
PosedPair singular(Random& random);
PosedPair degenerate(Random& random);

// With known answers, or exact contact between bodies in frames of their own. `steps`: units in the last place that the
// vertex in contact is moved by.
PosedPair vertex_on_face(Random& random, int steps);
PosedPair integer_rotations(Random& random);
PosedPair vertex_on_face_integer(Random& random, int steps);

}  // namespace ecods::scenes::hard
