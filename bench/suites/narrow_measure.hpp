// Runs the engines of the narrow phase on one workload, and judges their answers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engines/narrow_engine.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

struct NarrowRun {
    std::string name;
    bool is_ecods = false;
    std::vector<double> us;     // per query, one for each repetition
    std::vector<bool> answers;  // one for each query
    NarrowWork work;            // of all queries
    bool has_work = false;
    std::string failure;  // when it crashed, hung or threw: nothing above is there
};

// Engines take turns, each in a process of its own; the first turn of each is not timed.
std::vector<NarrowRun> measure_narrow(const scenes::MeshPairs& workload, std::span<const NarrowMaker> makers,
                                      std::size_t repetition_count);

struct ListRun {
    std::string name;
    bool is_ecods = false;
    std::vector<double> us;
    double pair_count = 0;       // listed, of all queries
    double false_negatives = 0;  // pairs of triangles
    double false_positives = 0;  // listed twice counts
    std::string failure;
};

using Lists = std::vector<std::vector<TrianglePair>>;  // one for each query, ascending

std::vector<ListRun> measure_lists(const scenes::MeshPairs& workload, const Lists& truth,
                                   std::span<const NarrowMaker> makers, std::size_t repetition_count);

// The answers of ECoDS, of which so many, spread evenly, are the oracle's; those count as wrong where the two differ.
struct NarrowTruth {
    std::vector<bool> answers;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;
};
NarrowTruth find_truth(const scenes::MeshPairs& workload, std::size_t judged_count);

struct ListTruth {
    Lists lists;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;  // lists
};
ListTruth find_lists(const scenes::MeshPairs& workload, std::size_t judged_count);

}  // namespace ecods::bench
