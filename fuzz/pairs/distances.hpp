// One run of the campaign of distances: pairs of posed meshes from a seed, every answer about their distance judged.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/pairs/run.hpp"

namespace ecods::fuzz {

struct DistanceCounts {
    std::uint64_t distances = 0;                                // of two bodies, each by the oracle
    std::map<std::string, std::array<std::uint64_t, 5>> kinds;  // by family, how often each ClosestKind was true
    Counters checks;                                            // by kind, how often it was made
};

inline constexpr std::uint64_t distances_per_run = 1000;

// Throws Disagreement at the first one. The same seed is the same run, on every machine. A lie of an answer: one
// distance is taken for the next double.
void run_distances(std::uint32_t seed, Lie lie, DistanceCounts& counts);

}  // namespace ecods::fuzz
