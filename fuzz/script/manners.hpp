// How a call is made, in ways that must not matter to what it does: with the world's own answers as arguments, or again
// and again while one of its allocations fails.
#pragma once

#include <string>
#include <vector>

#include "fuzz/base/counters.hpp"
#include "fuzz/script/scene.hpp"

namespace ecods::fuzz {

std::vector<std::string> manner_names();

// Makes the call in all worlds, but for one that is spared by turns, to which the others are compared. Throws
// CheckFailed where a call that failed has changed something; and Error if there is no manner of this name.
void make_in_manner(const Manner& manner, const Call& call, Scene& scene, Counters& counters);

}  // namespace ecods::fuzz
