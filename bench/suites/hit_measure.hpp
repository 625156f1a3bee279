// Runs the engines of hits on one workload, and judges their answers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engines/hit_engine.hpp"
#include "suites/hit_truth.hpp"

namespace ecods::bench {

struct HitRun {
    const HitMaker* maker = nullptr;
    std::vector<double> us;          // per segment, one for each repetition
    std::vector<HitAnswer> answers;  // one for each segment
    std::string failure;             // when it crashed, hung or threw: nothing above is there
};

// Engines take turns, each in a process of its own; the first turn of each is not timed.
std::vector<HitRun> measure_hits(const scenes::SegmentWorkload& workload, std::span<const HitMaker> makers,
                                 std::size_t repetition_count);

struct HitErrors {
    std::size_t false_negatives = 0;       // nothing reported where something is hit
    std::size_t false_positives = 0;       // reported where nothing is hit
    std::size_t other_triangles = 0;       // a triangle that is none of those hit first
    std::vector<double> parameter_errors;  // absolute, of segments that are hit and reported so
    std::size_t wrong = 0;                 // of ECoDS: whatever is not as it must be
};
HitErrors errors_of(const HitRun& run, const HitTruth& truth);

// The same for lists of all triangles that are hit.
struct HitListRun {
    const HitMaker* maker = nullptr;
    std::vector<double> us;
    double hit_count = 0;        // listed, of all segments
    double false_negatives = 0;  // triangles
    double false_positives = 0;  // listed twice counts
    std::string failure;
};
std::vector<HitListRun> measure_hit_lists(const scenes::SegmentWorkload& workload, const HitTruth& truth,
                                          std::span<const HitMaker> makers, std::size_t repetition_count);

}  // namespace ecods::bench
