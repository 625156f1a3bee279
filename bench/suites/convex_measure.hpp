// Runs the engines of convex solids on one workload, and judges their answers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engines/convex_engine.hpp"

namespace ecods::bench {

struct ConvexRun {
    const ConvexMaker* maker = nullptr;
    std::vector<double> us;             // per query, one for each repetition
    std::vector<ConvexAnswer> answers;  // one for each query
    std::string failure;                // when it crashed, hung or threw: nothing above is there
};

// The distances or depths, rounded once: those of ECoDS, of which so many, spread evenly, are the oracle's; those count
// as wrong where the two differ.
struct ConvexTruth {
    std::vector<double> numbers;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;
};
ConvexTruth find_convex_truth(const scenes::ConvexWorkload& workload, std::size_t judged_count);

// Engines take turns, each in a process of its own; the first turn of each is not timed.
std::vector<ConvexRun> measure_convex(const scenes::ConvexWorkload& workload, std::span<const ConvexMaker> makers,
                                      std::size_t repetition_count);

struct ConvexErrors {
    std::size_t contradicted = 0;    // said to meet where apart, or apart where they meet
    std::size_t off = 0;             // of the rest, by more than a hundredth of the true number
    std::size_t bad_directions = 0;  // of depths: along them, a hundredth more than the true depth does not part them
    double median = 0, most = 0;     // of what is not contradicted: absolute errors
    std::size_t wrong = 0;           // of ECoDS: whatever is not the true number, rounded once
};
ConvexErrors errors_of(const ConvexRun& run, const scenes::ConvexWorkload& workload, const ConvexTruth& truth);

}  // namespace ecods::bench
