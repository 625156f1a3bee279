// Two meshes: microseconds per query and wrong answers of every engine.
#include <fmt/core.h>

#include <algorithm>

#include "ecods/intersection.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/own_shapes.hpp"
#include "oracle/oracle.hpp"
#include "report/headline.hpp"
#include "scenes/narrow_workloads.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

using scenes::MeshPairs;
using scenes::MeshQuery;
using scenes::WorkloadSize;

WorkloadSize size_of(const SuiteOptions& options) {
    return options.is_long && !options.is_quick() ? WorkloadSize::large : options.workload_size();
}

oracle::OracleMesh for_oracle(const MeshPairs& workload, const scenes::MeshAt& at) {
    return {workload.meshes[at.mesh_index].mesh, at.pose};
}

struct TouchErrors : Errors {
    std::size_t wrong = 0;  // all of them
};

struct TouchSuite {
    using Question = Touch;
    using Truth = double;
    using Errors = TouchErrors;

    // The oracle needs about 0.1 us for each vertex of each query, and the rest for what is near.
    static std::size_t judged_count(const MeshPairs& workload, const SuiteOptions& options) {
        if (options.is_quick()) return 4;
        return triangle_count(workload.meshes) <= 2000 ? workload.queries.size() : 20;
    }

    static Truths<double> find_truths(const MeshPairs& workload, std::size_t judged_count) {
        const auto own = ecods_narrow().front().set_up(workload);
        return bench::find_truths<double>(
            workload.queries, judged_count, [&](const MeshQuery& query, std::size_t i) { return own->ask(query, i); },
            [&](const MeshQuery& query) {
                return oracle::intersects(for_oracle(workload, query.a), for_oracle(workload, query.b)) ? 1.0 : 0.0;
            });
    }

    static TouchErrors errors_of(const Run<Touch>& run, const MeshPairs& /*workload*/, const Truths<double>& truths) {
        TouchErrors errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            errors.false_negatives += run.answers[i] < truths.answers[i];
            errors.false_positives += run.answers[i] > truths.answers[i];
        }
        errors.wrong = errors.count();
        return errors;
    }

    static std::vector<std::string> cells(const Measured<TouchSuite>& measured, std::size_t i) {
        const Run<Touch>& run = measured.runs[i];
        const std::size_t count = measured.workload.queries.size();
        const auto per_query = [&](std::uint64_t Work::*member) {
            return run.work
                       ? fmt::format("{:.1f}", static_cast<double>((*run.work).*member) / static_cast<double>(count))
                       : std::string();
        };
        return {ratio_text(times_as_fast(run.us, measured.us_of(narrow_yardstick))),
                fmt::format("{} / {}", std::ranges::count(measured.truths.answers, 1), count),
                fmt::format("{}", measured.errors[i].false_negatives),
                fmt::format("{}", measured.errors[i].false_positives),
                per_query(&Work::box_tests),
                per_query(&Work::triangle_tests),
                fmt::format("{}", measured.truths.judged_count)};
    }

    static std::optional<double> error(const Measured<TouchSuite>& measured, std::size_t i) {
        return static_cast<double>(measured.errors[i].wrong) / static_cast<double>(measured.runs[i].answers.size());
    }

    static Table table(std::size_t repetition_count) {
        Table table = timed_table(
            two_meshes_title, {"times FCL", "hits", "false -", "false +", "box tests", "triangle tests", "judged"},
            repetition_count,
            {fmt::format(
                "Times FCL: how many times as fast as {}, in the same repetition. Judged: so many answers were "
                "checked by the oracle; the others by ECoDS.",
                narrow_yardstick)});
        table.is_summary = true;
        return table;
    }
};

using TouchMeasured = Measured<TouchSuite>;

// Wrong answers by gap, one column for each engine.
Table gap_table(std::span<const TouchMeasured> all) {
    Table table{
        .title = gaps_title,
        .header = {"gap in radii", "queries", "judged"},
        .notes = {
            "Half of the poses have the gap, half are as deep. Adjacent doubles: the two positions on a line between "
            "which contact begins; a gap of 1e-16 lies between these. Exact contact: the stacked bricks above.",
            "Judged: answers checked by the oracle."}};
    for (const Run<Touch>& run : all.front().runs) table.header.push_back(run.maker->name);
    for (const TouchMeasured& measured : all) {
        std::vector<std::string> row = {measured.workload.name, fmt::format("{}", measured.workload.queries.size()),
                                        fmt::format("{}", measured.truths.judged_count)};
        for (std::size_t i = 0; i < measured.runs.size(); ++i) {
            const auto& [false_negatives, false_positives] = static_cast<const Errors&>(measured.errors[i]);
            const std::string& failure = measured.runs[i].failure;
            row.push_back(failure.empty() ? fmt::format("{} / {}", false_negatives, false_positives) : failure);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

// All pairs of triangles, of one workload.
Table list_table(const MeshPairs& workload, const std::vector<NarrowMaker>& makers, const SuiteOptions& options,
                 bool& is_right) {
    const OwnShapes<MeshShape> posed(workload.meshes);
    QueryMemory memory;
    const auto truths = find_truths<std::vector<TrianglePair>>(
        workload.queries, TouchSuite::judged_count(workload, options),
        [&](const MeshQuery& query, std::size_t) {
            return intersecting_triangles(posed(query.a), posed(query.b), memory);
        },
        [&](const MeshQuery& query) {
            return oracle::intersecting_triangles(for_oracle(workload, query.a), for_oracle(workload, query.b));
        });
    is_right &= truths.wrong_count == 0;
    const auto runs = measure_lists<Touch>(workload, makers, truths.answers, options.repetition_count);
    Table table{
        .title = "All pairs of triangles that touch: " + workload.name,
        .header = {"engine", "us/query", "times FCL", "pairs/query", "false -", "false +"},
        .notes = {fmt::format("{} queries. FCL with contacts on, as many as there are. The oracle checked {} lists.",
                              workload.queries.size(), truths.judged_count)}};
    std::vector<double> yardstick;
    for (const ListRun<Touch>& run : runs)
        if (run.maker->name == narrow_yardstick) yardstick = run.us;
    for (const ListRun<Touch>& run : runs) {
        is_right &= !run.maker->is_ecods || (run.failure.empty() && run.errors.count() == 0);
        if (!run.failure.empty()) {
            table.rows.push_back({run.maker->name, run.failure, "", "", "", ""});
            continue;
        }
        table.rows.push_back(
            {run.maker->name, fmt::format("{:.2f}", median(run.us)), ratio_text(times_as_fast(run.us, yardstick)),
             fmt::format("{:.2f}", run.item_count / static_cast<double>(workload.queries.size())),
             fmt::format("{}", run.errors.false_negatives), fmt::format("{}", run.errors.false_positives)});
    }
    return table;
}

// The gaps come after the first `workload_count`.
Section chart_of(std::span<const TouchMeasured> all, std::size_t workload_count) {
    std::vector<Panel> panels;
    for (const TouchMeasured& measured : all.first(workload_count))
        panels.push_back(panel_of<TouchSuite>(measured.workload.name, "us per query", std::span(&measured, 1)));
    panels.push_back(
        panel_of<TouchSuite>("ships, gaps 1e-3 to adjacent doubles", "us per query", all.subspan(workload_count)));
    return {"Speed against error",
            {"Each engine is a point for each workload: time per query across, share of wrong answers up. The line at "
             "0 is no error at all. Near: two copies of a mesh whose gap, or depth, is 1e-4 to 1e-2 radii; half of "
             "them touch. Random: copies anywhere where their bounding balls overlap. Bricks and shafts: parts in "
             "exact contact, and the same parts with a clearance."},
            {},
            {},
            {error_chart("narrow-errors", std::move(panels),
                         "Speed against error. The better engine is lower and further left.")}};
}

}  // namespace

SuiteResult run_narrow(const SuiteOptions& options) {
    const std::vector<NarrowMaker> makers = options.wanted(options.is_main ? main_narrow_engines() : narrow_engines());
    SuiteResult result;
    std::vector<MeshPairs> workloads = narrow_workloads(size_of(options));
    const std::size_t workload_count = workloads.size();
    for (MeshPairs& workload : gap_workloads(size_of(options))) workloads.push_back(std::move(workload));
    Table table = TouchSuite::table(options.repetition_count);
    const auto all = measure_all<TouchSuite>(
        workloads, makers, options, "narrow",
        [&](const MeshPairs& workload) { return &workload < workloads.data() + workload_count ? &table : nullptr; },
        result);
    const std::span gaps = std::span(all).subspan(workload_count);
    std::vector<Table> tables = {table, gap_table(gaps)};
    std::vector<Truths<double>> truths_of_gaps;
    for (const TouchMeasured& measured : gaps) truths_of_gaps.push_back(measured.truths);
    Table distances = distance_table(std::span(workloads).subspan(workload_count), truths_of_gaps, makers);
    if (!distances.rows.empty()) tables.push_back(std::move(distances));
    tables.push_back(list_table(workloads.front(), makers, options, result.is_right));
    tables.push_back(build_table(build_workloads(size_of(options)), makers, options.repetition_count));
    for (const Table& each : tables) print(each, options);
    tables.push_back(use_table("How each engine is used", makers, poses_are_timed));
    if (options.has_pictures) result.sections.push_back(chart_of(all, workload_count));
    result.sections.push_back({"Two meshes", {}, std::move(tables), {}});
    return result;
}

}  // namespace ecods::bench
