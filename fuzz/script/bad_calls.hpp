// Calls that must be refused, and change nothing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/base/counters.hpp"
#include "fuzz/script/scene.hpp"

namespace ecods::fuzz {

std::vector<std::string> bad_call_names();

// Makes the call in every world. Throws CheckFailed unless the typed error comes and the worlds stay as they were; and
// Error if there is no call of this kind.
void make_bad_call(const BadCall& call, Scene& scene, Counters& counters);

}  // namespace ecods::fuzz
