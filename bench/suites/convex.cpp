// Two convex solids: how far are they from each other, and how deep in each other? And a thousand that move in a box.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "suites/comparison.hpp"
#include "suites/convex_frames.hpp"
#include "suites/convex_measure.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;
using scenes::ConvexWorkload;

struct Measured {
    const ConvexWorkload& workload;
    ConvexTruth truth;
    std::vector<ConvexRun> runs;
    std::vector<ConvexErrors> errors;  // of each run

    std::span<const double> us_of(const std::string& name) const {
        for (const ConvexRun& run : runs)
            if (run.maker->name == name) return run.us;
        return {};
    }
    bool is_right() const {
        bool is_right = truth.wrong_count == 0;
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (runs[i].maker->is_ecods) is_right &= runs[i].failure.empty() && errors[i].wrong == 0;
        return is_right;
    }
};

Measured measure(const ConvexWorkload& workload, std::span<const ConvexMaker> makers, const SuiteOptions& options) {
    // The oracle needs up to a tenth of a second for a pair of hulls.
    Measured measured{workload, find_convex_truth(workload, options.is_quick() ? 1 : 30), {}, {}};
    measured.runs = measure_convex(workload, makers, options.repetition_count);
    for (const ConvexRun& run : measured.runs) measured.errors.push_back(errors_of(run, workload, measured.truth));
    return measured;
}

void add_rows(Table& table, const Measured& measured) {
    const bool is_depth = measured.workload.question == ConvexQuestion::depth;
    for (std::size_t i = 0; i < measured.runs.size(); ++i) {
        const ConvexRun& run = measured.runs[i];
        const ConvexErrors& errors = measured.errors[i];
        add_row(table, {measured.workload.pairs.name, run.maker->name, run.us, run.failure}, [&] {
            std::vector<std::string> cells;
            const auto times = [&](const char* yardstick) {
                cells.push_back(ratio_text(times_as_fast(run.us, measured.us_of(yardstick))));
            };
            times(is_depth ? convex_depth_yardstick : convex_distance_yardstick);
            if (is_depth) times(convex_second_yardstick);
            cells.push_back(fmt::format("{}", errors.contradicted));
            cells.push_back(fmt::format("{}", errors.off));
            if (is_depth) cells.push_back(fmt::format("{}", errors.bad_directions));
            cells.push_back(error_text(errors.median));
            cells.push_back(error_text(errors.most));
            cells.push_back(run.maker->is_ecods ? fmt::format("{}", errors.wrong) : std::string());
            cells.push_back(fmt::format("{} / {}", measured.truth.judged_count, measured.truth.numbers.size()));
            return cells;
        });
    }
}

Table empty_table(ConvexQuestion question, std::size_t repetition_count) {
    const bool is_depth = question == ConvexQuestion::depth;
    Table table =
        is_depth
            ? timed_table("Two convex solids that overlap: how deep?",
                          {"times libccd", "times Bullet", "said apart", "off by 1 %", "bad way", "median error",
                           "most error", "wrong", "judged"},
                          repetition_count)
            : timed_table("Two convex solids that are apart: how far?",
                          {"times FCL", "said to meet", "off by 1 %", "median error", "most error", "wrong", "judged"},
                          repetition_count);
    table.notes.push_back(
        is_depth ? fmt::format("Times libccd, times Bullet: how many times as fast as {} and {}, in the same "
                               "repetition. Bad way: moved along the direction given, by 1.01 of the true depth, b "
                               "still overlaps a.",
                               convex_depth_yardstick, convex_second_yardstick)
                 : fmt::format("Times FCL: how many times as fast as {}, in the same repetition.",
                               convex_distance_yardstick));
    table.notes.push_back(
        "Errors: absolute, of a size of about 1, where what is said is not contradicted by the truth. Wrong: answers "
        "of ECoDS that are not the true number, rounded once. Judged: so many of the true numbers are the oracle's, "
        "which tries every normal in rationals; the others are those of ECoDS.");
    return table;
}

Panel panel_of(const Measured& measured) {
    std::vector<ErrorPoint> points;
    for (std::size_t i = 0; i < measured.runs.size(); ++i) {
        if (!measured.runs[i].failure.empty()) continue;
        const ConvexErrors& errors = measured.errors[i];
        points.push_back({measured.runs[i].maker->name, median(measured.runs[i].us),
                          static_cast<double>(errors.contradicted + errors.off) /
                              static_cast<double>(measured.truth.numbers.size())});
    }
    return error_panel(measured.workload.pairs.name, "us per query", points);
}

struct Part {
    ConvexQuestion question;
    const char* title;
    const char* picture;
};

void measure_part(const Part& part, const std::vector<ConvexWorkload>& workloads, const SuiteOptions& options,
                  SuiteResult& result) {
    std::vector<ConvexMaker> makers = convex_engines(part.question);
    options.keep_wanted(makers);
    if (makers.empty()) return;
    Table table = empty_table(part.question, options.repetition_count);
    std::vector<Panel> panels;
    {
        process::Progress progress(part.picture, workloads.size());
        for (const ConvexWorkload& workload : workloads) {
            if (workload.question == part.question) {
                const Measured measured = measure(workload, makers, options);
                result.is_right &= measured.is_right();
                add_rows(table, measured);
                panels.push_back(panel_of(measured));
            }
            progress.step();
        }
    }
    print(table);
    Section section{
        part.title, {}, {table, use_table<ConvexMaker>("How each engine is asked", makers, poses_are_timed)}, {}};
    if (options.has_pictures)
        section.charts.push_back(error_chart(
            part.picture, std::move(panels),
            "Speed against error. Up: the share of pairs that are wrongly said to meet or to be apart, or of which the "
            "number is off by more than a hundredth. The better engine is lower and further left."));
    result.sections.push_back(std::move(section));
}

}  // namespace

SuiteResult run_convex(const SuiteOptions& options) {
    SuiteResult result;
    const std::vector<ConvexWorkload> workloads =
        scenes::convex_workloads(options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full);
    for (const Part& part : {Part{ConvexQuestion::distance, "Distances of convex solids", "convex-distances"},
                             Part{ConvexQuestion::depth, "Depths of convex solids", "convex-depths"}})
        measure_part(part, workloads, options, result);
    if (const auto frames = convex_frames_table(options, result.is_right)) {
        print(*frames);
        result.sections.push_back({"Convex solids that move in a box", {}, {*frames}, {}});
    }
    return result;
}

}  // namespace ecods::bench
