// Statistics count the work of a World.
//
// Memory of a world: 165 bytes a body; 55 to 66 bytes a pair of overlapping boxes, 16 for each list that contains the
// pair, and 4 while it is tested; spare capacity for growth; and the broad phase's own memory. An update before which
// nothing changed has constant cost. A pair at rest costs nothing at any update: the work is that of the broad phase
// for the boxes that moved, and one two-body test for each candidate pair with a body that moved. If a collision begins
// or ends, the list of colliding pairs is shifted from that pair on. A clearance costs all of this a second time, for
// larger boxes and the pairs within the clearance; without a clearance there is no such cost.
//
// Example: verify/examples/how_do_i, count_the_work().
#pragma once

#include <cstddef>
#include <cstdint>

#include "ecods/ask.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// Counts the work for the clearance. The clearance has candidate pairs of its own: pairs whose boxes overlap after each
// box is enlarged by half the clearance on all sides. `two_body_tests` to `visited_pairs` are sums over the world's
// life; `broad_phase` counts since there was last no clearance; the other members are as of the last update.
struct ClearanceStatistics {
    std::uint64_t two_body_tests = 0;  // tests of whether a pair is within the clearance; colliding pairs need none
    std::uint64_t cache_hits = 0;
    std::uint64_t visited_pairs = 0;
    BroadPhaseCounts broad_phase;

    std::size_t candidate_count = 0;
    std::size_t filtered_count = 0;
    std::size_t close_count = 0;
};

// Counts the work of a world. `updates` to `visited_pairs` are sums over the world's life; the others are present
// values.
struct Statistics {
    std::uint64_t updates = 0;
    std::uint64_t moved_bodies = 0;    // bodies that were new, moved or reshaped at an update
    std::uint64_t two_body_tests = 0;  // candidate pairs tested at updates
    std::uint64_t cache_hits = 0;      // candidate pairs whose verdict was still valid at updates
    std::uint64_t visited_pairs = 0;   // pairs that updates processed: they began, ended, or have a body that changed
    BroadPhaseCounts broad_phase;
    QueryCounts queries;  // of mesh pairs, at updates; questions are counted by Ask::counts
    ClearanceStatistics clearance;

    std::size_t body_count = 0;
    std::size_t overlapping_count = 0;  // as of the last update
    std::size_t filtered_count = 0;     // pairs whose boxes overlap and that are filtered out
    std::size_t colliding_count = 0;

    // Counts the bytes that the world holds for bodies and pairs, spare capacity included, without meshes and broad
    // phase.
    std::size_t memory_bytes = 0;
};

}  // namespace ecods
