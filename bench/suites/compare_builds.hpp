// Two builds of ecods_bench against each other, work and answers before times: a guard against regressions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "suites/own_work.hpp"

namespace ecods::bench {

// What both builds gave for one workload, turn by turn; empty for a build that does not have the workload.
struct PairedSamples {
    std::string workload;
    std::vector<OwnSample> before;
    std::vector<OwnSample> after;
};

struct BuildComparison {
    Table table;
    bool is_same = true;   // answers and counts; of the workloads that both have
    double ratio_max = 0;  // the largest median of new/old, and the workload that has it; none is empty
    std::string slowest;
};

// Answers and counts are compared exactly. Times are compared by their ratios, turn by turn: a build is called faster
// or slower when at least six ratios, all but a tenth of them, and more than 2 % at the median say so. Times do not
// enter is_same: on a machine that others use as well they cannot be relied on.
BuildComparison compare_samples(const std::vector<PairedSamples>& all);

// Starts both programs with --own and `options` and lets them take turns, workload by workload, the order changing from
// turn to turn. Throws std::runtime_error when one of them cannot be started, ends early or has no --own.
BuildComparison compare_builds(const std::string& before, const std::string& after, std::size_t repetition_count,
                               const std::vector<std::string>& options);

}  // namespace ecods::bench
