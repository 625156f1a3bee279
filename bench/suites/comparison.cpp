#include "suites/comparison.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "report/headline.hpp"

namespace ecods::bench {

namespace {

std::size_t hit_count(const SceneRun& run) {
    std::size_t count = 0;
    for (const std::vector<IndexPair>& hits : run.hits) count += hits.size();
    return count;
}

std::string per_frame(std::size_t sum, std::size_t frame_count) {
    return fmt::format("{:.2f}", static_cast<double>(sum) / static_cast<double>(frame_count));
}

}  // namespace

Comparison compare_engines(const scenes::Scene& scene, const std::string& title, const SuiteOptions& options,
                           Detail detail) {
    Comparison result;
    result.runs = measure_scene(scene, scene_engines(), options.repetition_count, title);
    result.truth = ask_oracle(scene, detail, title);

    result.table.title = title;
    result.table.header = {"engine", "ms/frame", "candidate pairs/frame", "hits/frame", "false -", "false +"};
    const std::size_t frame_count = scene.frames.size() + 1;
    for (const SceneRun& run : result.runs) {
        const Errors errors = compare(run.hits, result.truth);
        if (run.is_ecods && errors.count() > 0) result.is_right = false;
        result.table.rows.push_back({run.name, fmt::format("{:.4f}", run.mean_ms()),
                                     per_frame(run.candidate_count, frame_count),
                                     per_frame(hit_count(run), frame_count), fmt::format("{}", errors.false_negatives),
                                     fmt::format("{}", errors.false_positives)});
    }
    result.table.notes = {
        fmt::format("{} frames. The oracle judged {} pairs of bodies in {:.1f} s: {} by triangles, the "
                    "rest by certified boxes or because they rest.",
                    frame_count, result.truth.pair_count, result.truth.seconds, result.truth.exact_count)};
    return result;
}

Table work_table(const std::vector<SceneRun>& runs, const std::string& title) {
    Table table{.title = title};
    table.header = {"engine",     "moved bodies",   "two-body tests", "cache hits", "tests of body boxes",
                    "list swaps", "tests of nodes", "triangle pairs", "integers"};
    for (const SceneRun& run : runs) {
        if (!run.statistics) continue;
        const Statistics& s = *run.statistics;
        std::vector<std::string> row = {run.name};
        for (const std::uint64_t count :
             {s.moved_bodies, s.two_body_tests, s.cache_hits, s.broad_phase.box_tests, s.broad_phase.swaps,
              s.queries.box_tests, s.queries.stages.triangle_tests,
              s.queries.stages.one_limb + s.queries.stages.two_limbs + s.queries.stages.many_limbs})
            row.push_back(fmt::format("{}", count));
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        "Counts of work, summed over all frames. The last column: triangle pairs that the filter left open."};
    return table;
}

void print(const Table& table) {
    fmt::print("{}\n", to_text(table));
    std::fflush(stdout);
}

void print(const Table& table, const SuiteOptions& options) {
    if (!options.is_main) print(table);
}

void print_summary(const SuiteResult& result) {
    for (const Section& section : result.sections) {
        for (const Table& table : section.tables) {
            if (!table.is_summary) continue;
            Table summary = ratio_table(table, table.title).value_or(table);
            if (summary.notes.size() > 1) summary.notes.clear();
            print(summary);
        }
    }
}

}  // namespace ecods::bench
