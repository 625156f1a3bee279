#include "suites/hit_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/error_panel.hpp"
#include "suites/comparison.hpp"
#include "suites/hit_measure.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::SegmentWorkload;

// The oracle looks at every triangle, by rationals.
std::size_t judged_count(const SegmentWorkload& workload, const SuiteOptions& options) {
    if (workload.bodies.size() > 1) return 4;
    const std::size_t triangles = triangle_count(workload.meshes);
    if (options.is_quick()) return 2;
    return triangles <= 2000 ? 50 : triangles <= 20000 ? 20 : triangles <= 200000 ? 4 : 1;
}

struct Measured {
    const SegmentWorkload& workload;
    HitTruth truth;
    std::vector<HitRun> runs;
    std::vector<HitListRun> list_runs;

    std::span<const double> us_of(const std::string& name) const {
        for (const HitRun& run : runs)
            if (run.maker->name == name) return run.us;
        return {};
    }
    bool is_right() const {
        return truth.wrong_count == 0 &&
               std::ranges::all_of(runs,
                                   [&](const HitRun& run) {
                                       return !run.maker->is_ecods ||
                                              (run.failure.empty() && errors_of(run, truth).wrong == 0);
                                   }) &&
               std::ranges::all_of(list_runs, [](const HitListRun& run) {
                   return !run.maker->is_ecods ||
                          (run.failure.empty() && run.false_negatives + run.false_positives == 0);
               });
    }
};

// `chords` are ECoDS's times for those of the same mesh.
void add_rows(Table& table, const Measured& measured, std::span<const double> chords) {
    for (const HitRun& run : measured.runs) {
        add_row(table, {measured.workload.name, run.maker->name, run.us, run.failure}, [&] {
            const HitErrors errors = errors_of(run, measured.truth);
            const std::vector<double>& parameters = errors.parameter_errors;
            return std::vector<std::string>{
                share_text(run.us, measured.us_of(hit_yardstick)),
                run.maker->is_ecods ? share_text(run.us, chords) : std::string(),
                fmt::format("{} / {}", measured.truth.hit_segment_count(), measured.workload.segments.size()),
                fmt::format("{}", errors.false_negatives),
                fmt::format("{}", errors.false_positives),
                fmt::format("{}", errors.other_triangles),
                error_text(median(parameters)),
                error_text(parameters.empty() ? 0 : *std::ranges::max_element(parameters)),
                run.maker->is_ecods ? fmt::format("{}", errors.wrong) : std::string(),
                fmt::format("{}", measured.truth.judged_count)};
        });
    }
}

Table empty_table(std::size_t repetition_count) {
    Table table = timed_table("Segments against a mesh: what is hit first?",
                              {"of Embree", "of chords", "hit", "false -", "false +", "other triangle", "median error",
                               "most error", "wrong", "judged"},
                              repetition_count);
    table.notes.insert(
        table.notes.end(),
        {fmt::format(
             "Of Embree: time over that of {}, in the same repetition, less is better. Of chords: over ECoDS's for "
             "chords of the same mesh.",
             hit_yardstick),
         "False -: nothing reported, though the segment hits the closed triangles at their exact places. False +: "
         "reported where it hits none. Other triangle: none of those that share the first point. Errors: of the "
         "parameter, from 0 to 1. Wrong: answers of ECoDS that are not the true parameter, rounded once, and the "
         "least triangle.",
         "Judged: so many of the lists of all hits are the oracle's; the others are those of ECoDS. Peers are given "
         "the posed vertices, rounded: those in float round once more. Of an Embree that answers sixteen segments in "
         "one call there is a row, as ECoDS takes one at a time; rtcIntersect1M() and a batch in many threads were "
         "not asked."});
    return table;
}

void add_list_rows(Table& table, const Measured& measured) {
    std::span<const double> yardstick;
    for (const HitListRun& run : measured.list_runs)
        if (run.maker->name == hit_yardstick) yardstick = run.us;
    for (const HitListRun& run : measured.list_runs) {
        add_row(table, {measured.workload.name, run.maker->name, run.us, run.failure}, [&] {
            const auto count = static_cast<double>(measured.workload.segments.size());
            return std::vector<std::string>{share_text(run.us, yardstick), fmt::format("{:.2f}", run.hit_count / count),
                                            fmt::format("{:.0f}", run.false_negatives),
                                            fmt::format("{:.0f}", run.false_positives)};
        });
    }
}

Table empty_list_table(std::size_t repetition_count) {
    Table table = timed_table("Segments against a mesh: all triangles that are hit",
                              {"of Embree", "hits/segment", "false -", "false +"}, repetition_count);
    table.notes.emplace_back(
        "False: triangles that are not listed, and that are listed and not hit, of all segments. ECoDS's lists have "
        "exact order, points and features, the others triangles alone.");
    return table;
}

Section chart_of(const std::vector<Measured>& all) {
    std::vector<Panel> panels;
    for (const Measured& measured : all) {
        std::vector<ErrorPoint> points;
        for (const HitRun& run : measured.runs) {
            if (!run.failure.empty() || run.maker->is_for_paths) continue;
            const HitErrors errors = errors_of(run, measured.truth);
            const std::size_t bad = errors.false_negatives + errors.false_positives + errors.other_triangles;
            points.push_back(
                {run.maker->name, median(run.us), static_cast<double>(bad) / static_cast<double>(run.answers.size())});
        }
        panels.push_back(error_panel(measured.workload.name, "us per segment", points));
    }
    return {"Segments: speed against error",
            {"Each engine is a point for each workload: time per segment across; up the share of segments whose first "
             "hit is missed, is none, or is another triangle. The line at 0 is no error at all."},
            {},
            {},
            {error_chart("hit-errors", std::move(panels),
                         "Speed against error of first hits. The better engine is lower and further left.")}};
}

}  // namespace

SuiteResult run_hits(const SuiteOptions& options) {
    std::vector<HitMaker> makers = hit_engines();
    options.keep_wanted(makers);
    SuiteResult result;
    if (makers.empty()) return result;
    const std::vector<SegmentWorkload> workloads =
        scenes::segment_workloads(options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full);
    Table table = empty_table(options.repetition_count), lists = empty_list_table(options.repetition_count);
    std::vector<Measured> all;
    std::map<const Mesh*, std::vector<double>> chords;  // ECoDS's times for a mesh's first workload
    {
        process::Progress progress("hits", workloads.size());
        for (const SegmentWorkload& workload : workloads) {
            HitTruth truth = find_hits(workload, judged_count(workload, options));
            auto runs = measure_hits(workload, makers, options.repetition_count);
            auto list_runs = measure_hit_lists(workload, truth, makers, options.repetition_count);
            all.push_back({workload, std::move(truth), std::move(runs), std::move(list_runs)});
            const Measured& measured = all.back();
            result.is_right &= measured.is_right();
            const std::span<const double> own = measured.us_of(workload.bodies.size() > 1 ? own_world_hits : own_hits);
            add_rows(table, measured,
                     chords.try_emplace(workload.meshes.front().mesh.get(), own.begin(), own.end()).first->second);
            add_list_rows(lists, measured);
            progress.step();
        }
    }
    print(table);
    print(lists);
    if (options.has_pictures) result.sections.push_back(chart_of(all));
    result.sections.push_back({"Segments against one mesh",
                               {},
                               {table, lists,
                                use_table<HitMaker>("How each engine is asked for hits", makers,
                                                    "Building trees, and posing vertices for the peers, is outside "
                                                    "the times.")},
                               {}});
    return result;
}

}  // namespace ecods::bench
