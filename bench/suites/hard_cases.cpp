// The configurations on which other libraries were reported to fail: who is right about which.
#include <fmt/core.h>

#include <chrono>

#include "engines/narrow_engine.hpp"
#include "process/contained.hpp"
#include "process/progress.hpp"
#include "scenes/io/hard_case_file.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

using scenes::HardCase;

constexpr std::chrono::seconds answer_limit{10};

struct Verdict {
    std::string text;
    bool is_right = false;
};

// Both orders of arguments, in a process of its own: some of these end it.
Verdict ask(const NarrowMaker& maker, const HardCase& hard) {
    const scenes::MeshAt a{0, hard.a.pose}, b{1, hard.b.pose};
    const scenes::MeshPairs both{hard.id, {{"A", hard.a.mesh}, {"B", hard.b.mesh}}, {{a, b}, {b, a}}};
    const auto start = [&]() -> process::Contained::Run {
        std::shared_ptr<Touch::Engine> engine = maker.set_up(both);
        return [engine, &both] {
            std::vector<double> answers(2);
            engine->ask_all(both.queries, answers);
            return answers;
        };
    };
    const process::Outcome outcome = process::Contained(start, answer_limit).run();
    if (!outcome.is_right()) return {outcome.failure, false};
    const bool there = outcome.values[0] != 0, back = outcome.values[1] != 0;
    if (there != back) return {"differs when swapped", false};
    if (there == hard.intersects) return {"right", true};
    return {there ? "false positive" : "false negative", false};
}

}  // namespace

SuiteResult run_hard_cases(const SuiteOptions& options) {
    const std::vector<NarrowMaker> makers = options.wanted(narrow_engines());
    std::vector<HardCase> cases =
        scenes::read_hard_cases(ECODS_BENCH_SOURCE "/verify/hard_cases/hard_cases.json").cases;
    if (options.is_quick()) cases.resize(3);

    Table table{
        .title = "Hard cases: do they touch?",
        .header = {"case", "touch"},
        .text_columns = 2 + makers.size(),
        .notes = {"Each with its source in verify/hard_cases/hard_cases.json. Both orders of arguments are asked.",
                  "Crashed: the engine's process ended by a signal; each case is asked in a process of its own."}};
    std::vector<std::string> totals = {fmt::format("right, of {}", cases.size()), ""};
    SuiteResult result;
    process::Progress progress("hard cases", makers.size());
    std::vector<std::vector<std::string>> columns;
    for (const NarrowMaker& maker : makers) {
        table.header.push_back(maker.name);
        std::size_t right_count = 0;
        std::vector<std::string> column;
        for (const HardCase& hard : cases) {
            const Verdict verdict = ask(maker, hard);
            right_count += verdict.is_right;
            result.is_right &= verdict.is_right || !maker.is_ecods;
            column.push_back(verdict.text);
        }
        columns.push_back(std::move(column));
        totals.push_back(std::to_string(right_count));
        progress.step();
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        std::vector<std::string> row = {cases[i].id, cases[i].intersects ? "yes" : "no"};
        for (const auto& column : columns) row.push_back(column[i]);
        table.rows.push_back(std::move(row));
    }
    table.rows.push_back(std::move(totals));
    print(table);
    result.sections.push_back({"Hard cases",
                               {"Configurations that were reported to other libraries as wrong answers, or that were "
                                "found in them here, with exact answers computed in rational arithmetic."},
                               {std::move(table)},
                               {}});
    return result;
}

}  // namespace ecods::bench
