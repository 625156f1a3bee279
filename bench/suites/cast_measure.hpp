// Runs the engines of casts on one workload, and judges their answers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/cast.hpp"
#include "engines/cast_engine.hpp"

namespace ecods::bench {

// The first contact of each motion: that of ECoDS, of which so many, spread evenly, are judged by the oracle; those
// count as wrong that differ from its own.
struct CastTruth {
    std::vector<std::optional<FirstContact>> contacts;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;

    std::size_t contact_count() const;
};
CastTruth find_contacts(const scenes::CastWorkload& workload, std::size_t judged_count);

struct CastRun {
    const CastMaker* maker = nullptr;
    std::vector<double> us;       // per motion, one for each repetition
    std::vector<double> answers;  // one for each motion; a time, or NaN
    std::string failure;          // when it crashed, hung or threw: nothing above is there
};

// Engines take turns, each in a process of its own; the first turn of each is not timed.
std::vector<CastRun> measure_casts(const scenes::CastWorkload& workload, std::span<const CastMaker> makers,
                                   std::size_t repetition_count);

struct CastErrors {
    std::size_t false_negatives = 0;  // no contact reported where there is one
    std::size_t false_positives = 0;  // reported where there is none
    std::vector<double> time_errors;  // absolute, where there is one and it is reported
    std::size_t wrong = 0;            // of ECoDS: whatever is not as it must be
};
CastErrors errors_of(const CastRun& run, const CastTruth& truth);

}  // namespace ecods::bench
