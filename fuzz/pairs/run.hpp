// One run of the pair campaign: pairs of posed triangles from a seed, each decided by every path and by the oracle.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/base/recipe.hpp"
#include "query/intersection/triangle_relations.hpp"

namespace ecods::fuzz {

struct PairCounts {
    std::uint64_t pairs = 0;
    std::map<std::string, std::array<std::uint64_t, 3>> relations;  // by family, as the oracle has them
    Counters checks;                                                // by kind, how often it was made
    StageCounts stages;                                             // of all questions to body pairs
};

// The library and the oracle of a pair do not agree; or the oracle and the recipe of the pair do not, and then `path`
// is recipe_check, and the library was not asked.
struct Disagreement {
    std::uint32_t seed = 0;
    std::uint64_t pair = 0;  // how many pairs of the run came before
    std::string family = {};
    std::string path = {};  // which answer was wrong, and how the pair was written
    std::string expected = {};
    std::string got = {};
    std::string text = {};  // the pair in hexadecimal floats
};

// A run takes something for true on purpose, once, to see that it is found out: a wrong answer, or a promise of a
// recipe (of what is known of the case, or that a mesh bounds a solid) that is not kept.
enum class Lie { none, answer, recipe };

inline constexpr std::uint64_t pairs_per_run = 1000;

// Throws Disagreement at the first one. The same seed is the same run, on every machine. A lie of an answer: one
// touching pair is taken for crossing.
void run_pairs(std::uint32_t seed, Lie lie, PairCounts& counts);

}  // namespace ecods::fuzz
