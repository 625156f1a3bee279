// One run of the pair campaign: pairs of posed triangles from a seed, each decided by every path and by the oracle.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods::fuzz {

struct PairCounts {
    std::uint64_t pairs = 0;
    std::map<std::string, std::array<std::uint64_t, 3>> relations;  // by family, as the oracle has them
    Counters checks;                                                // by kind, how often it was made
    StageCounts stages;                                             // of all questions to body pairs
};

// The library, the oracle and the recipe of a pair do not agree.
struct Disagreement {
    std::uint32_t seed = 0;
    std::uint64_t pair = 0;  // how many pairs of the run came before
    std::string family = {};
    std::string path = {};  // which answer was wrong, and how the pair was written
    std::string expected = {};
    std::string got = {};
    std::string text = {};  // the pair in hexadecimal floats
};

inline constexpr std::uint64_t pairs_per_run = 1000;

// Throws Disagreement at the first one. The same seed is the same run, on every machine. `lie`: take one touching pair
// for crossing.
void run_pairs(std::uint32_t seed, bool lie, PairCounts& counts);

}  // namespace ecods::fuzz
