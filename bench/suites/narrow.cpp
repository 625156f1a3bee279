// Two meshes: microseconds per query and wrong answers of every engine.
#include <fmt/core.h>

#include <algorithm>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "report/headline.hpp"
#include "scenes/narrow_workloads.hpp"
#include "suites/comparison.hpp"
#include "suites/narrow_builds.hpp"
#include "suites/narrow_distances.hpp"
#include "suites/narrow_measure.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::MeshPairs;
using scenes::WorkloadSize;

WorkloadSize size_of(const SuiteOptions& options) {
    if (options.is_quick()) return WorkloadSize::tiny;
    return options.is_long ? WorkloadSize::large : WorkloadSize::full;
}

// The oracle needs about 0.1 us for each vertex of each query, and the rest for what is near.
std::size_t judged_count(const MeshPairs& workload, const SuiteOptions& options) {
    if (options.is_quick()) return 4;
    return triangle_count(workload.meshes) <= 2000 ? workload.queries.size() : 20;
}

struct Measured {
    const MeshPairs& workload;
    NarrowTruth truth;
    std::vector<NarrowRun> runs;

    // Wrong answers of a run: false negatives, false positives.
    std::pair<std::size_t, std::size_t> errors(const NarrowRun& run) const {
        std::size_t false_negatives = 0, false_positives = 0;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            if (truth.answers[i] && !run.answers[i]) ++false_negatives;
            if (!truth.answers[i] && run.answers[i]) ++false_positives;
        }
        return {false_negatives, false_positives};
    }

    double wrong_share(const NarrowRun& run) const {
        const auto [false_negatives, false_positives] = errors(run);
        return static_cast<double>(false_negatives + false_positives) / static_cast<double>(run.answers.size());
    }

    bool is_right() const {
        return truth.wrong_count == 0 && std::all_of(runs.begin(), runs.end(), [&](const NarrowRun& run) {
                   return !run.is_ecods || (run.failure.empty() && wrong_share(run) == 0);
               });
    }
};

Measured measure_one(const MeshPairs& workload, std::span<const NarrowMaker> makers, const SuiteOptions& options) {
    NarrowTruth truth = find_truth(workload, judged_count(workload, options));
    return {workload, std::move(truth), measure_narrow(workload, makers, options.repetition_count)};
}

std::span<const double> yardstick_of(const std::vector<NarrowRun>& runs) {
    for (const NarrowRun& run : runs)
        if (run.name == narrow_yardstick) return run.us;
    return {};
}

void add_rows(Table& table, const Measured& measured) {
    const auto count = static_cast<double>(measured.workload.queries.size());
    const auto hits = std::count(measured.truth.answers.begin(), measured.truth.answers.end(), true);
    for (const NarrowRun& run : measured.runs) {
        add_row(table, {measured.workload.name, run.name, run.us, run.failure}, [&] {
            const auto [false_negatives, false_positives] = measured.errors(run);
            const auto per_query = [&](std::uint64_t work) {
                return run.has_work ? fmt::format("{:.1f}", static_cast<double>(work) / count) : std::string();
            };
            return std::vector<std::string>{ratio_text(times_as_fast(run.us, yardstick_of(measured.runs))),
                                            fmt::format("{} / {}", hits, measured.workload.queries.size()),
                                            fmt::format("{}", false_negatives),
                                            fmt::format("{}", false_positives),
                                            per_query(run.work.box_tests),
                                            per_query(run.work.triangle_tests),
                                            fmt::format("{}", measured.truth.judged_count)};
        });
    }
}

Table empty_table(const std::string& title, std::size_t repetition_count) {
    Table table = timed_table(
        title, {"times FCL", "hits", "false -", "false +", "box tests", "triangle tests", "judged"}, repetition_count);
    table.notes.push_back(
        fmt::format("Times FCL: how many times as fast as {}, in the same repetition. Judged: so many answers were "
                    "checked by the oracle; the others by ECoDS.",
                    narrow_yardstick));
    return table;
}

// Wrong answers by gap, one column for each engine.
Table gap_table(std::span<const Measured> all) {
    Table table;
    table.title = gaps_title;
    table.header = {"gap in radii", "queries", "judged"};
    for (const NarrowRun& run : all.front().runs) table.header.push_back(run.name);
    for (const Measured& measured : all) {
        std::vector<std::string> row = {measured.workload.name, fmt::format("{}", measured.workload.queries.size()),
                                        fmt::format("{}", measured.truth.judged_count)};
        for (const NarrowRun& run : measured.runs) {
            const auto [false_negatives, false_positives] = measured.errors(run);
            row.push_back(run.failure.empty() ? fmt::format("{} / {}", false_negatives, false_positives) : run.failure);
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        "Half of the poses have the gap, half are as deep. Adjacent doubles: the two positions on a line between "
        "which contact begins; a gap of 1e-16 lies between these. Exact contact: the stacked bricks above.",
        "Judged: answers checked by the oracle."};
    return table;
}

Table list_table(const MeshPairs& workload, const ListTruth& truth, const std::vector<ListRun>& runs) {
    Table table;
    table.title = "All pairs of triangles that touch: " + workload.name;
    table.header = {"engine", "us/query", "times FCL", "pairs/query", "false -", "false +"};
    std::vector<double> yardstick;
    for (const ListRun& run : runs)
        if (run.name == narrow_yardstick) yardstick = run.us;
    for (const ListRun& run : runs) {
        if (!run.failure.empty()) {
            table.rows.push_back({run.name, run.failure, "", "", "", ""});
            continue;
        }
        table.rows.push_back({run.name, fmt::format("{:.2f}", median(run.us)),
                              ratio_text(times_as_fast(run.us, yardstick)),
                              fmt::format("{:.2f}", run.pair_count / static_cast<double>(workload.queries.size())),
                              fmt::format("{:.0f}", run.false_negatives), fmt::format("{:.0f}", run.false_positives)});
    }
    table.notes = {fmt::format("{} queries. FCL with contacts on, as many as there are. The oracle checked {} lists.",
                               workload.queries.size(), truth.judged_count)};
    return table;
}

Panel panel_of(const std::string& title, std::span<const Measured> all) {
    std::vector<ErrorPoint> points;
    for (std::size_t e = 0; e < all.front().runs.size(); ++e) {
        std::vector<double> us;
        double wrong = 0;
        for (const Measured& measured : all) {
            if (!measured.runs[e].failure.empty()) continue;
            us.push_back(median(measured.runs[e].us));
            wrong += measured.wrong_share(measured.runs[e]);
        }
        if (!us.empty())
            points.push_back({all.front().runs[e].name, median(us), wrong / static_cast<double>(us.size())});
    }
    return error_panel(title, "us per query", points);
}

// The gaps come after the first `workload_count`.
Section chart_of(std::span<const MeshPairs> workloads, std::span<const Measured> all, std::size_t workload_count,
                 const SuiteOptions& options) {
    Section section{
        "Speed against error",
        {"Each engine is a point for each workload: time per query across, share of wrong answers up. The line at "
         "0 is no error at all. Near: two copies of a mesh whose gap, or depth, is 1e-4 to 1e-2 radii; half of "
         "them touch. Random: copies anywhere where their bounding balls overlap. Bricks and shafts: parts in "
         "exact contact, and the same parts with a clearance."},
        {},
        {}};
    if (!options.has_pictures) return section;
    std::vector<Panel> panels;
    for (std::size_t i = 0; i < workload_count; ++i) panels.push_back(panel_of(workloads[i].name, all.subspan(i, 1)));
    panels.push_back(panel_of("ships, gaps 1e-3 to adjacent doubles", all.subspan(workload_count)));
    section.charts.push_back(error_chart("narrow-errors", std::move(panels),
                                         "Speed against error. The better engine is lower and further left."));
    return section;
}

}  // namespace

SuiteResult run_narrow(const SuiteOptions& options) {
    std::vector<NarrowMaker> makers = options.is_main ? main_narrow_engines() : narrow_engines();
    options.keep_wanted(makers);
    const std::size_t repetition_count = options.repetition_count;
    SuiteResult result;

    std::vector<MeshPairs> workloads = narrow_workloads(size_of(options));
    const std::size_t workload_count = workloads.size();
    for (MeshPairs& workload : gap_workloads(size_of(options))) workloads.push_back(std::move(workload));
    Table table = empty_table(two_meshes_title, repetition_count);
    table.is_summary = true;
    std::vector<Measured> all;
    {
        process::Progress progress("narrow", workloads.size());
        for (const MeshPairs& workload : workloads) {
            all.push_back(measure_one(workload, makers, options));
            result.is_right &= all.back().is_right();
            if (all.size() <= workload_count) add_rows(table, all.back());
            progress.step();
        }
    }
    print(table, options);
    const Table gaps = gap_table(std::span(all).subspan(workload_count));
    print(gaps, options);
    std::vector<NarrowTruth> truth_of_gaps;
    for (std::size_t i = workload_count; i < all.size(); ++i) truth_of_gaps.push_back(all[i].truth);
    const Table distances = distance_table(std::span(workloads).subspan(workload_count), truth_of_gaps, makers);
    if (!distances.rows.empty()) print(distances, options);

    std::vector<NarrowMaker> listing = makers;
    std::erase_if(listing, [](const NarrowMaker& maker) { return !maker.has_lists; });
    const ListTruth lists = find_lists(workloads.front(), judged_count(workloads.front(), options));
    const std::vector<ListRun> list_runs = measure_lists(workloads.front(), lists.lists, listing, repetition_count);
    const Table list = list_table(workloads.front(), lists, list_runs);
    print(list, options);
    result.is_right &= lists.wrong_count == 0;
    for (const ListRun& run : list_runs)
        result.is_right &= !run.is_ecods || (run.failure.empty() && run.false_negatives + run.false_positives == 0);

    const Table builds = build_table(build_workloads(size_of(options)), makers, repetition_count);
    print(builds, options);

    Section chart = chart_of(workloads, all, workload_count, options);
    if (!chart.charts.empty()) result.sections.push_back(std::move(chart));
    std::vector<Table> tables = {table, gaps};
    if (!distances.rows.empty()) tables.push_back(distances);
    tables.insert(tables.end(),
                  {list, builds, use_table<NarrowMaker>("How each engine is used", makers, poses_are_timed)});
    result.sections.push_back({"Two meshes", {}, std::move(tables), {}});
    return result;
}

}  // namespace ecods::bench
