// Calls that must fail, and leave no trace.
#pragma once

#include "fuzz/counters.hpp"
#include "fuzz/scene.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Makes one bad call. Throws CheckFailed unless the typed error comes and the worlds stay as they were.
void give_bad_input(Scene& scene, scenes::Random& random, Counters& counters);

}  // namespace ecods::fuzz
