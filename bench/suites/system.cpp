// The report's two experiments: ships in a room, their number growing, the volume or the density kept.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <span>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/chart.hpp"
#include "scenes/room.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"
#include "suites/system_measure.hpp"

namespace ecods::bench {

namespace {

struct Experiment {
    std::string name;   // of files
    std::string title;  // for people
    std::string figure;
    bool keeps_density = false;
    std::size_t count_max = 0;  // of ships
};

// Beyond so many ships nobody waits for every pair.
std::size_t all_pairs_max(const SuiteOptions& options) {
    return options.is_main ? 512 : 1024;
}

std::vector<std::size_t> ship_counts(const Experiment& experiment, const SuiteOptions& options) {
    std::vector<std::size_t> counts;
    for (std::size_t count = 2; count <= experiment.count_max; count *= 2)
        if (options.wants(count) && (!options.is_quick() || count == 4 || count == 64)) counts.push_back(count);
    return counts;
}

// Fewer frames of more ships, in which as much happens; at least 20, so that what is done once in some frames is met.
std::size_t room_frame_count(std::size_t ships, const SuiteOptions& options) {
    if (options.is_quick()) return 3;
    return std::clamp<std::size_t>((options.is_long ? 40'000 : 6'400) / ships,
                                   std::min<std::size_t>(20, options.frame_count), options.frame_count);
}

std::size_t judged_count(std::size_t ships, const SuiteOptions& options) {
    if (options.is_quick()) return 2;
    return ships <= 64 ? 20 : ships <= 256 ? 5 : 1;
}

struct Size {
    std::size_t ships = 0;
    SystemTruth truth;
    std::vector<SystemRun> runs;

    const SystemRun* find(const std::string& name) const {
        for (const SystemRun& run : runs)
            if (run.name == name && run.failure.empty()) return &run;
        return nullptr;
    }
};

Size run_size(const Experiment& experiment, std::size_t ships, const SuiteOptions& options) {
    const scenes::Scene scene = scenes::room(
        {.ship_count = ships,
         .frame_count = room_frame_count(ships, options),
         .side = experiment.keeps_density ? scenes::calibrated_side_by_density(ships) : scenes::calibrated_side(),
         .seed = 10});
    std::vector<SceneMaker> makers = options.wanted(system_engines());
    std::erase_if(makers, [&](const SceneMaker& maker) {
        return maker.name == scene_fcl_all_pairs && ships > all_pairs_max(options);
    });
    Size size{ships, find_hits(scene, judged_count(ships, options), experiment.title), {}};
    size.runs = measure_systems(scene, size.truth, makers, options.repetition_count);
    return size;
}

// Engines in the order of their first appearance; the largest sizes have fewer.
std::vector<std::string> engine_names(const std::vector<Size>& sizes) {
    std::vector<std::string> names;
    for (const Size& size : sizes)
        for (const SystemRun& run : size.runs)
            if (std::find(names.begin(), names.end(), run.name) == names.end()) names.push_back(run.name);
    return names;
}

Table time_table(const Experiment& experiment, const std::vector<Size>& sizes, std::size_t repetition_count) {
    Table table{.title = experiment.title + ": mean milliseconds per frame (times as fast as FCL's tree)",
                .header = {"ships", "hits/frame", "judged frames"},
                .is_summary = true};
    const std::vector<std::string> names = engine_names(sizes);
    for (const std::string& name : names) table.header.push_back(name);
    for (const Size& size : sizes) {
        std::vector<std::string> row = {fmt::format("{}", size.ships),
                                        fmt::format("{:.2f}", size.truth.hits_per_frame()),
                                        fmt::format("{} of {}", size.truth.judged_count, size.truth.hits.size())};
        const SystemRun* yardstick = size.find(scene_yardstick);
        for (const std::string& name : names) {
            const SystemRun* run = size.find(name);
            row.push_back(run == nullptr ? "" : fmt::format("{:.4f}", median(run->ms)));
            if (run != nullptr && yardstick != nullptr && run != yardstick) {
                const double times = times_as_fast(run->ms, yardstick->ms);
                row.back() += fmt::format(" ({:.{}f})", times, times < 1 ? 2 : 1);
            }
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {fmt::format("Processor time: {}; 20 ms untimed before each; each engine pinned in a process of its "
                               "own.",
                               medians_of(repetition_count)),
                   "Judged: frames checked by the oracle; the others by ECoDS, whose broad phases must agree."};
    return table;
}

Table work_table(const Experiment& experiment, const std::vector<Size>& sizes) {
    Table table{
        .title = experiment.title + ": calls of the two-body test per frame, and false negatives / false positives",
        .header = {"ships"}};
    const std::vector<std::string> names = engine_names(sizes);
    for (const std::string& name : names) table.header.push_back(name);
    for (const Size& size : sizes) {
        std::vector<std::string> row = {fmt::format("{}", size.ships)};
        for (const std::string& name : names) {
            const SystemRun* run = size.find(name);
            row.push_back(run == nullptr ? ""
                                         : fmt::format("{:.1f}, {} / {}", run->calls, run->errors.false_negatives,
                                                       run->errors.false_positives));
        }
        for (const SystemRun& run : size.runs)
            if (!run.failure.empty()) row.front() += fmt::format(" ({} {})", run.name, run.failure);
        table.rows.push_back(std::move(row));
    }
    return table;
}

// How something grows with the number of bodies.
struct GrowthCurve {
    std::string name;
    std::vector<double> x, y;
};

// With the values where the marks are; all are "per frame".
Panel growth_panel(const std::string& title, const std::string& unit, std::span<const GrowthCurve> curves) {
    Panel panel{.title = title,
                .x = {.title = "ships", .is_logarithmic = true},
                .y = {.title = unit + " per frame", .is_logarithmic = true},
                .curves = {},
                .has_lines = true};
    for (const GrowthCurve& growth : curves) {
        Curve& curve = panel.curves.emplace_back();
        curve.name = growth.name;
        for (std::size_t i = 0; i < growth.x.size(); ++i)
            curve.points.push_back(
                {growth.x[i], growth.y[i],
                 fmt::format("{}: {:.0f} ships, {:.3g} {}", growth.name, growth.x[i], growth.y[i], unit)});
    }
    return panel;
}

// One curve for each engine, by the `value` of a run.
template <class Value>
std::vector<GrowthCurve> curves_of(const std::vector<Size>& sizes, const Value& value) {
    std::vector<GrowthCurve> curves;
    for (const std::string& name : engine_names(sizes)) {
        GrowthCurve& curve = curves.emplace_back();
        curve.name = name;
        for (const Size& size : sizes) {
            const SystemRun* run = size.find(name);
            if (run == nullptr) continue;
            curve.x.push_back(static_cast<double>(size.ships));
            curve.y.push_back(value(*run));
        }
    }
    return curves;
}

std::string exponent_of(const GrowthCurve& curve) {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.x[i] < 64 || curve.y[i] <= 0) continue;
        x.push_back(curve.x[i]);
        y.push_back(curve.y[i]);
    }
    if (x.size() < 3) return "";
    const PowerLaw law = fit_power_law(x, y);
    return fmt::format("{:.2f} ± {:.2f}", law.exponent, law.exponent_error);
}

Table exponent_table(const Experiment& experiment, const std::vector<GrowthCurve>& times,
                     const std::vector<GrowthCurve>& calls, const GrowthCurve& hits) {
    Table table{.title = experiment.title + ": growth from 64 ships on, the power of their number",
                .header = {"engine", "time", "calls"},
                .notes = {"Fitted by least squares to the logarithms, with the standard error."}};
    for (std::size_t i = 0; i < times.size(); ++i)
        table.rows.push_back({times[i].name, exponent_of(times[i]), exponent_of(calls[i])});
    table.rows.push_back({"collisions", "", exponent_of(hits)});
    return table;
}

Section run_experiment(const Experiment& experiment, const SuiteOptions& options, bool& is_right) {
    std::vector<Size> sizes;
    const std::vector<std::size_t> counts = ship_counts(experiment, options);
    {
        process::Progress progress(experiment.title, counts.size());
        for (const std::size_t ships : counts) {
            const Size& size = sizes.emplace_back(run_size(experiment, ships, options));
            is_right &= size.truth.wrong_count == 0;
            for (const SystemRun& run : size.runs)
                is_right &= !run.is_ecods || (run.failure.empty() && run.errors.count() == 0);
            progress.step();
        }
    }
    const std::vector<GrowthCurve> times = curves_of(sizes, [](const SystemRun& run) { return median(run.ms); });
    const std::vector<GrowthCurve> calls = curves_of(sizes, [](const SystemRun& run) { return run.calls; });
    GrowthCurve hits{"collisions", {}, {}};
    for (const Size& size : sizes) {
        hits.x.push_back(static_cast<double>(size.ships));
        hits.y.push_back(size.truth.hits_per_frame());
    }
    Section section{experiment.title,
                    {},
                    {time_table(experiment, sizes, options.repetition_count), work_table(experiment, sizes),
                     exponent_table(experiment, times, calls, hits)},
                    {}};
    for (const Table& table : section.tables) print(table, options);
    if (!options.has_pictures) return section;
    std::vector<GrowthCurve> work = calls;
    work.push_back(hits);
    section.charts.push_back({"system-" + experiment.name,
                              {growth_panel("Time", "milliseconds", times),
                               growth_panel("Collisions, and calls of the two-body test", "pairs", work)},
                              experiment.figure +
                                  " of the ECoDS report: time per frame, and collisions and calls of the two-body test "
                                  "per frame."});
    return section;
}

}  // namespace

SuiteResult run_system(const SuiteOptions& options) {
    SuiteResult result;
    const std::vector<Experiment> experiments = {
        {"volume", "Ever more ships in the same room", "Figure 5", false, options.is_long ? 4096u : 1024u},
        {"density", "Ever more ships at the same density", "Figure 6", true, 4096}};
    for (const Experiment& experiment : experiments)
        result.sections.push_back(run_experiment(experiment, options, result.is_right));
    return result;
}

}  // namespace ecods::bench
