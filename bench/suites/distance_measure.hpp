// Runs the engines of distances on one workload, and judges their answers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engines/distance_engine.hpp"
#include "scenes/distance_workloads.hpp"

namespace ecods::bench {

struct DistanceRun {
    const DistanceMaker* maker = nullptr;
    std::vector<double> us;       // per query, one for each repetition
    std::vector<double> answers;  // one for each query
    std::string failure;          // when it crashed, hung or threw: nothing above is there
};

// The distances, rounded once: those of ECoDS, of which so many, spread evenly, are the oracle's; those count as wrong
// where the two differ.
struct DistanceTruth {
    std::vector<double> distances;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;
};
DistanceTruth find_distances(const scenes::DistanceWorkload& workload, std::size_t judged_count);

// Engines take turns, each in a process of its own; the first turn of each is not timed.
std::vector<DistanceRun> measure_distances(const scenes::DistanceWorkload& workload, const DistanceTruth& truth,
                                           std::span<const DistanceMaker> makers, std::size_t repetition_count);

// Errors in units in the last place of the true distances, where bodies are apart. An answer of 0 there is counted by
// itself.
struct DistanceErrors {
    std::vector<double> ulps;
    std::size_t false_zeros = 0;
    std::size_t wrong = 0;  // of ECoDS: whatever is not as it must be
};
DistanceErrors errors_of(const DistanceRun& run, const DistanceTruth& truth);

}  // namespace ecods::bench
