// One run of the campaigns of solids: pairs of posed solids from a seed, every answer about them judged.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/pairs/run.hpp"

namespace ecods::fuzz {

struct SolidCounts {
    std::uint64_t solids = 0;               // pairs of them
    std::map<std::string, Counters> kinds;  // by family, how often each SolidRelation was true
    Counters checks;                        // by kind, how often it was made
};

inline constexpr std::uint64_t solids_per_run = 130;
inline constexpr std::uint64_t polycubes_per_run = 1000;

// Throw Disagreement at the first one. The same seed is the same run, on every machine. `lie`: what is taken
// for true, once.

// All families of solid_cases.hpp, by the oracle and by their recipes; in other environments, and with meshes that
// bound no solid.
void run_solids(std::uint32_t seed, Lie lie, SolidCounts& counts);

// Sets of unit cells under random affine maps, by the sets alone, without the oracle.
void run_polycubes(std::uint32_t seed, Lie lie, SolidCounts& counts);

// A polycube of up to four cells, which the seed names, and each that is not after it, in all positions of the lattice
// in which their boxes share a point: seeds 1 to 19 are all pairs of up to three cells, 1 to 105 of up to four.
void run_placements(std::uint32_t seed, Lie lie, SolidCounts& counts);

}  // namespace ecods::fuzz
