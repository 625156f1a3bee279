// All that must hold after an update.
#pragma once

#include "fuzz/counters.hpp"
#include "fuzz/scene.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

struct CheckOptions {
    bool canary = false;  // take the first collision for none
};

// Checks both worlds against the oracle, against each other, against a fresh world, and from inside. Throws
// CheckFailed.
void check_frame(Scene& scene, const CheckOptions& options, scenes::Random& random, Counters& counters);

}  // namespace ecods::fuzz
