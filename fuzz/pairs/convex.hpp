// One run of the campaign of convex solids: pairs of them from a seed, every answer about them judged.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/pairs/run.hpp"

namespace ecods::fuzz {

struct ConvexCounts {
    std::uint64_t convex = 0;               // pairs of solids
    std::map<std::string, Counters> kinds;  // by family, what was so of them
    Counters checks;                        // by kind, how often it was made
};

inline constexpr std::uint64_t convex_per_run = 180;

// Throws Disagreement at the first one, with a case made as small as it is easily made. The same seed is the same run,
// on every machine. A lie of an answer: the depth of one is taken for the next double.
void run_convex(std::uint32_t seed, Lie lie, ConvexCounts& counts);

}  // namespace ecods::fuzz
