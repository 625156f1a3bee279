// Two meshes: how far are they from each other? Microseconds per query, and errors in units in the last place.
#include <fmt/core.h>

#include <algorithm>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "suites/clearance.hpp"
#include "suites/comparison.hpp"
#include "suites/distance_measure.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::DistanceWorkload;

// The oracle needs milliseconds for a ship, half a second for a hundred thousand triangles.
std::size_t judged_count(const DistanceWorkload& workload, const SuiteOptions& options) {
    const std::size_t triangles = triangle_count(workload.pairs.meshes);
    if (options.is_quick()) return 3;
    return triangles <= 2000 ? workload.pairs.queries.size() : triangles <= 20000 ? 20 : 4;
}

struct Measured {
    const DistanceWorkload& workload;
    DistanceTruth truth;
    std::vector<DistanceRun> runs;

    std::span<const double> us_of(const std::string& name) const {
        for (const DistanceRun& run : runs) {
            if (run.maker->name == name) return run.us;
        }
        return {};
    }
    bool is_right() const {
        return truth.wrong_count == 0 && std::ranges::all_of(runs, [&](const DistanceRun& run) {
                   return !run.maker->is_ecods || (run.failure.empty() && errors_of(run, truth).wrong == 0);
               });
    }
};

std::string ulps_text(double ulps) {
    return ulps < 1e6 ? fmt::format("{:.4g}", ulps) : fmt::format("{:.1e}", ulps);
}

void add_rows(Table& table, const Measured& measured) {
    for (const DistanceRun& run : measured.runs) {
        add_row(table, {measured.workload.pairs.name, run.maker->name, run.us, run.failure}, [&] {
            const DistanceErrors errors = errors_of(run, measured.truth);
            const bool has_ulps = !errors.ulps.empty();
            return std::vector<std::string>{
                ratio_text(times_as_fast(run.us, measured.us_of(distance_yardstick))),
                share_text(run.us, measured.us_of(own_distance)),
                has_ulps ? ulps_text(median(errors.ulps)) : std::string(),
                has_ulps ? ulps_text(*std::ranges::max_element(errors.ulps)) : std::string(),
                fmt::format("{}", errors.false_zeros),
                run.maker->is_ecods ? fmt::format("{}", errors.wrong) : std::string(),
                fmt::format("{} / {}", measured.truth.judged_count, measured.truth.distances.size())};
        });
    }
}

Table empty_table(std::size_t repetition_count) {
    Table table = timed_table(
        "Two meshes: how far are they from each other?",
        {"times FCL", "of a distance", "median ulps", "most ulps", "false zeros", "wrong", "judged"}, repetition_count);
    for (const std::string& note :
         {fmt::format("Times FCL: how many times as fast as {}, in the same repetition. Of a distance: time over "
                      "that of ECoDS's distance.",
                      distance_yardstick),
          std::string("Ulps: errors in units in the last place of the true distance, where bodies are apart; 0 "
                      "where they are apart is counted as false zero. Of bounds: the upper end. Wrong: answers of "
                      "ECoDS that are not the true ones, rounded once, or do not contain them."),
          std::string("Judged: so many of the true distances are the oracle's; the others are those of ECoDS. "
                      "Bullet's meshes and CGAL's trees answer no distances of two meshes.")})
        table.notes.push_back(note);
    return table;
}

// One panel for each workload, of the engines that answer with a number.
Section chart_of(const std::vector<Measured>& all) {
    std::vector<Panel> panels;
    for (const Measured& measured : all) {
        std::vector<ErrorPoint> points;
        for (const DistanceRun& run : measured.runs) {
            const DistanceErrors errors = errors_of(run, measured.truth);
            if (!run.failure.empty() || errors.ulps.empty() || run.maker->answer == DistanceAnswer::within) continue;
            points.push_back({run.maker->name, median(run.us), median(errors.ulps)});
        }
        panels.push_back(error_panel(measured.workload.pairs.name, "us per query", points, ErrorScale::ulps));
    }
    return {"Distances: speed against error",
            {"Each engine is a point for each workload: time per query across; up the median of its errors, in units "
             "in the last place of the true distance. The line at 0 is no error at all: rounded once."},
            {},
            {},
            {error_chart("distance-errors", std::move(panels),
                         "Speed against error of distances. The better engine is lower and further left.")}};
}

}  // namespace

SuiteResult run_distance(const SuiteOptions& options) {
    std::vector<DistanceMaker> makers = distance_engines();
    options.keep_wanted(makers);
    SuiteResult result;
    const std::vector<DistanceWorkload> workloads =
        scenes::distance_workloads(options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full);
    Table table = empty_table(options.repetition_count);
    std::vector<Measured> all;
    {
        process::Progress progress("distance", workloads.size());
        for (const DistanceWorkload& workload : workloads) {
            DistanceTruth truth = find_distances(workload, judged_count(workload, options));
            auto runs = measure_distances(workload, truth, makers, options.repetition_count);
            all.push_back({workload, std::move(truth), std::move(runs)});
            result.is_right &= all.back().is_right();
            add_rows(table, all.back());
            progress.step();
        }
    }
    print(table);
    if (options.has_pictures) result.sections.push_back(chart_of(all));
    result.sections.push_back(
        {"Distances of two meshes",
         {},
         {table, use_table<DistanceMaker>("How each engine is asked for distances", makers, poses_are_timed)},
         {}});
    const Table clearance = clearance_table(options, result.is_right);
    print(clearance);
    result.sections.push_back({"Pairs within a clearance", {}, {clearance}, {}});
    return result;
}

}  // namespace ecods::bench
