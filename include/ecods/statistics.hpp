// The work of a World as counts, and its costs.
//
// Memory of a world: 165 bytes a body; 55 to 66 bytes a pair of overlapping boxes, 16 for each list that holds the
// pair, 4 while it is tested; spare capacity for growth; and the broad phase's own. An update before which nothing
// changed costs a constant, and a pair at rest costs nothing at any update: work is that of the broad phase for the
// boxes that moved, and one two-body test for each candidate pair of which a body moved. Where a collision begins or
// ends, what lies behind it in the list of colliding pairs is moved. A clearance costs the same a second time, for
// boxes that reach further and pairs within it; without one it costs nothing.
//
// Example: verify/examples/how_do_i, count_the_work().
#pragma once

#include <cstddef>
#include <cstdint>

#include "ecods/ask.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// The work for the clearance. It has candidate pairs of its own: those whose boxes, enlarged by half the clearance on
// all sides, overlap. `two_body_tests` to `visited_pairs` sum over the world's life, `broad_phase` over the time since
// there was no clearance; the rest is as of the last update.
struct ClearanceStatistics {
    std::uint64_t two_body_tests = 0;  // pairs asked whether they are within the clearance; colliding ones are not
    std::uint64_t cache_hits = 0;
    std::uint64_t visited_pairs = 0;
    BroadPhaseCounts broad_phase;

    std::size_t candidate_count = 0;
    std::size_t filtered_count = 0;
    std::size_t close_count = 0;
};

// The work of a world. `updates` to `visited_pairs` sum over the world's life; the rest is of now.
struct Statistics {
    std::uint64_t updates = 0;
    std::uint64_t moved_bodies = 0;    // bodies that were new, or were given another pose or shape, at an update
    std::uint64_t two_body_tests = 0;  // candidate pairs given to a two-body test at updates
    std::uint64_t cache_hits = 0;      // candidate pairs whose verdict was kept at updates
    std::uint64_t visited_pairs = 0;   // pairs that updates looked at: began, ended, or of a body that changed
    BroadPhaseCounts broad_phase;
    QueryCounts queries;  // of mesh pairs, at updates; Ask::counts has those of questions
    ClearanceStatistics clearance;

    std::size_t body_count = 0;
    std::size_t overlapping_count = 0;  // as of the last update
    std::size_t filtered_count = 0;     // pairs whose boxes overlap and that are filtered out
    std::size_t colliding_count = 0;

    // Held by the world for bodies and pairs, spare capacity included; meshes and the broad phase not.
    std::size_t memory_bytes = 0;
};

}  // namespace ecods
