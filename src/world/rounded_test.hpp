// Makes the two-body tests of rounded shapes, which every world has from the start.
#pragma once

#include "world/two_body_tests.hpp"

namespace ecods {

// Adds the tests of rounded shapes with each other and with meshes.
void add_rounded_tests(TwoBodyTests& tests);

}  // namespace ecods
