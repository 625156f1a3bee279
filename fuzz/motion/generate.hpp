// A script from a seed.
#pragma once

#include <cstdint>

#include "fuzz/base/counters.hpp"
#include "fuzz/motion/profile.hpp"
#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

// The same profile and seed are the same script, on every machine. No world takes part, so that a script can be had
// again after a crash.
Script generate(const Profile& profile, std::uint32_t seed, Counters& counters);

}  // namespace ecods::fuzz
