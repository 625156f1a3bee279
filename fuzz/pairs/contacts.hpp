// One run of the campaigns of hits and of casts: lines and bodies, or bodies on their way, from a seed, every answer
// about them judged.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/pairs/run.hpp"

namespace ecods::fuzz {

struct HitCounts {
    std::uint64_t lines = 0;
    std::map<std::string, Counters> kinds;  // by family, how often each HitKind was that of the first hit
    Counters checks;                        // by kind, how often it was made
};

struct CastCounts {
    std::uint64_t casts = 0;                // by a translation, and between poses
    std::map<std::string, Counters> kinds;  // by family, how often each ClosestKind was true
    Counters checks;
};

inline constexpr std::uint64_t hits_per_run = 2000;
inline constexpr std::uint64_t casts_per_run = 250;

// Throw Disagreement at the first one, with a case made as small as it is easily made. The same seed is the same run,
// on every machine. `lie`: what is taken for true, once.
void run_hits(std::uint32_t seed, Lie lie, HitCounts& counts);
void run_casts(std::uint32_t seed, Lie lie, CastCounts& counts);

}  // namespace ecods::fuzz
