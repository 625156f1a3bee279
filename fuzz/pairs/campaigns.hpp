// The campaigns of cases, beside those of worlds in motion: pairs of triangles, of bodies, of lines and bodies, drawn
// from a seed by families, and every answer about them judged.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "fuzz/base/counters.hpp"
#include "fuzz/base/recipe.hpp"

namespace ecods::fuzz {

struct CaseCounts {
    std::uint64_t cases = 0;
    std::map<std::string, Counters> kinds;  // by family, how often each kind of answer was true
    Counters checks;                        // by kind, how often it was made
    Counters stages;                        // of questions to body pairs, how often each decided
};

// The library and the oracle of a case do not agree; or the oracle and the recipe of the case do not, and then `path`
// is recipe_check, and the library was not asked.
struct Disagreement {
    std::uint32_t seed = 0;
    std::uint64_t index = 0;  // how many cases of the run came before
    std::string family = {};
    std::string path = {};  // which answer was wrong, and how the case was written
    std::string expected = {};
    std::string got = {};
    std::string text = {};  // the case in hexadecimal floats, made as small as it is easily made
};

// A run takes something for true on purpose, once, to see that it is found out: a wrong answer, or a promise of a
// recipe (of what is known of the case, or that a mesh bounds a solid) that is not kept.
enum class Lie { none, answer, recipe };

struct CaseCampaign {
    const char* profile;  // its name
    const char* about;
    const char* noun;  // for what it counts

    // One run. Throws Disagreement at the first one. The same seed is the same run, on every machine.
    void (*run)(std::uint32_t seed, Lie lie, CaseCounts& counts);
};
std::span<const CaseCampaign> case_campaigns();

void run_pairs(std::uint32_t seed, Lie lie, CaseCounts& counts);
void run_distances(std::uint32_t seed, Lie lie, CaseCounts& counts);
void run_hits(std::uint32_t seed, Lie lie, CaseCounts& counts);
void run_casts(std::uint32_t seed, Lie lie, CaseCounts& counts);

// All families of turn_cases.hpp, by the oracle; and by pieces of the time, which share nothing with it. Small ones
// also as ways of turns, with the points and normals of contacts, and the gap between the end of the turn and a pose.
void run_turns(std::uint32_t seed, Lie lie, CaseCounts& counts);

// Turns of small integers, without the oracle: at times at which poses are doubles, up to a factor, bodies do not
// intersect before the first time; and where they do intersect, it is not later.
void run_turn_samples(std::uint32_t seed, Lie lie, CaseCounts& counts);

// Ways of several nodes made of turn_cases.hpp, by the oracle: leg and time, and the share of the whole time.
void run_ways(std::uint32_t seed, Lie lie, CaseCounts& counts);

// Meshes whose vertices go where bodies of cast_cases.hpp go, or to a point, a plane or each other's places; by the
// oracle, beside a body that moves and beside another such mesh.
void run_deforming(std::uint32_t seed, Lie lie, CaseCounts& counts);

void run_convex(std::uint32_t seed, Lie lie, CaseCounts& counts);

// Worlds of meshes, solids, convex solids, rounded bodies and half spaces that come, go, jump, and change shapes, radii
// and filters: all lists after each frame, by the oracle.
void run_kinds(std::uint32_t seed, Lie lie, CaseCounts& counts);

// All families of solid_cases.hpp, by the oracle and by their recipes; in other environments, and with meshes that
// bound no solid.
void run_solids(std::uint32_t seed, Lie lie, CaseCounts& counts);

// Sets of unit cells under random affine maps, by the sets alone, without the oracle.
void run_polycubes(std::uint32_t seed, Lie lie, CaseCounts& counts);

// A polycube of up to four cells, which the seed names, and each that is not after it, in all positions of the lattice
// in which their boxes share a point: seeds 1 to 19 are all pairs of up to three cells, 1 to 105 of up to four.
void run_placements(std::uint32_t seed, Lie lie, CaseCounts& counts);

}  // namespace ecods::fuzz
