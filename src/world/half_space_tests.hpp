// Adds the two-body tests of half spaces, which every world has from the start.
#pragma once

#include "world/two_body_tests.hpp"

namespace ecods {

// Adds to `tests` the tests of half spaces with meshes, with rounded bodies, and with each other.
void add_half_space_tests(TwoBodyTests& tests);

}  // namespace ecods
