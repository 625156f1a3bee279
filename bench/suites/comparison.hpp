// All engines on one scene, judged by the oracle: the table that every suite shows.
#pragma once

#include <string>
#include <vector>

#include "harness/judge.hpp"
#include "harness/scene_runs.hpp"
#include "report/table.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

struct Comparison {
    std::vector<SceneRun> runs;
    Truth truth;
    Table table;           // engine, ms per frame, candidate pairs, hits, false negatives and positives
    bool is_right = true;  // no wrong answer of ECoDS
};

Comparison compare_engines(const scenes::Scene& scene, const std::string& title, const SuiteOptions& options,
                           Detail detail = Detail::hits_only);

// What ECoDS counted, for the runs that have statistics.
Table work_table(const std::vector<SceneRun>& runs, const std::string& title);

void print(const Table& table);  // to standard output, at once

// Prints likewise, but nothing in the main job, which prints a summary when a suite has ended.
void print(const Table& table, const SuiteOptions& options);

// Prints the tables that are a summary of their suite, of engines' times on workloads the ratios.
void print_summary(const SuiteResult& result);

}  // namespace ecods::bench
