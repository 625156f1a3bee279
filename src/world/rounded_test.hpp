// Makes the two-body tests of rounded shapes, which every world has from the start.
#pragma once

#include <optional>

#include "query/body/rounded_pair.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

// Adds to `tests` the tests of rounded shapes with each other and with meshes.
void add_rounded_tests(TwoBodyTests& tests);

// Returns a rounded shape or a mesh, of whatever form, as a core and a radius; nullopt for any other shape.
std::optional<CoreAndRadius> core_and_radius(const Posed<Shape>& posed);
// Returns the same core and radius; throws NotSupported, about a cast, for any other shape.
CoreAndRadius require_core(const Posed<Shape>& posed);

}  // namespace ecods
