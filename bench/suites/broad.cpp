// Boxes only: nanoseconds per box and frame, the full list of pairs delivered in every frame.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "harness/statistics.hpp"
#include "process/progress.hpp"
#include "report/headline.hpp"
#include "suites/broad_measure.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using scenes::BoxLayout;
using scenes::BoxMotion;
using scenes::MovingBoxesOptions;

// A workload of the main ones is run by all engines, one of the others by those of `motion_engines`.
struct Workload {
    MovingBoxesOptions boxes;
    bool is_main = true;
};
constexpr std::array motion_engines = {
    "ECoDS, automatic",     "ECoDS, kept candidates", "ECoDS, sweep and prune", broad_scratch,
    broad_scratch_unsorted, broad_yardstick,          "FCL tree, moved only",   "Bullet Dbvt"};

// Engines that fatten boxes see all of them leave their fat boxes together, some 40 frames apart. Fewer frames would
// miss that, or show little else.
std::size_t frame_count(std::size_t box_count, const SuiteOptions& options) {
    if (options.is_quick()) return 3;
    if (options.is_main) return 100;
    if (box_count > 160'000) return 20;
    if (box_count > 16'000) return options.is_long ? 120 : 60;
    return (options.is_long ? 2u : 1u) * std::clamp<std::size_t>(300'000 / box_count, 150, 300);
}

// Of processor time, for one turn of an engine: more frames are not waited for.
double turn_seconds(const SuiteOptions& options) {
    return options.is_long ? 10 : options.is_main ? 0.7 : 2;
}

void add_main_workloads(const SuiteOptions& options, std::vector<Workload>& list) {
    const auto add = [&](BoxLayout layout, BoxMotion motion, std::size_t count) {
        if (options.wants(count)) list.push_back({{layout, motion, count, frame_count(count, options)}});
    };
    add(BoxLayout::dense, BoxMotion::all, 1000);
    if (options.is_quick()) {
        for (const BoxLayout layout : {BoxLayout::sparse, BoxLayout::pile, BoxLayout::decades})
            add(layout, BoxMotion::all, 1000);
        for (const BoxMotion motion : {BoxMotion::tenth, BoxMotion::teleport, BoxMotion::none})
            add(BoxLayout::dense, motion, 1000);
        return;
    }
    add(BoxLayout::dense, BoxMotion::all, 10'000);
    if (!options.is_main) add(BoxLayout::dense, BoxMotion::all, 100'000);
    add(BoxLayout::sparse, BoxMotion::all, 10'000);
    if (options.is_long) add(BoxLayout::sparse, BoxMotion::all, 100'000);
    add(BoxLayout::pile, BoxMotion::all, 10'000);
    if (options.is_long) add(BoxLayout::pile, BoxMotion::all, 100'000);
    add(BoxLayout::dense, BoxMotion::tenth, 10'000);
    add(BoxLayout::dense, BoxMotion::teleport, 10'000);
    if (options.is_long) add(BoxLayout::dense, BoxMotion::teleport, 100'000);
    add(BoxLayout::decades, BoxMotion::all, 10'000);
    if (options.is_long) add(BoxLayout::decades, BoxMotion::all, 100'000);
    if (!options.is_main) add(BoxLayout::dense, BoxMotion::none, 10'000);
}

// What boxes do that the main workloads leave out: they are fast, move together, come, go, begin to move, lie in
// clusters or beside large ones.
void add_motions(std::size_t count, const SuiteOptions& options, std::vector<Workload>& list) {
    const auto add = [&](BoxLayout layout, BoxMotion motion, double speed = 0.01) {
        if (!options.wants(count)) return;
        const std::size_t frames = std::min<std::size_t>(frame_count(count, options), options.is_long ? 150 : 100);
        list.push_back({{layout, motion, count, frames, speed}, false});
    };
    if (options.is_main) {
        for (const BoxMotion motion : {BoxMotion::churn, BoxMotion::random, BoxMotion::one_new})
            add(BoxLayout::dense, motion);
        return;
    }
    for (const double speed : {0.03, 0.06, 0.1, 0.5}) add(BoxLayout::dense, BoxMotion::all, speed);
    add(BoxLayout::ball, BoxMotion::turn);
    add(BoxLayout::ball, BoxMotion::fly);
    for (const BoxMotion motion :
         {BoxMotion::churn, BoxMotion::churn_at_rest, BoxMotion::burst, BoxMotion::random, BoxMotion::one_new})
        add(BoxLayout::dense, motion);
    add(BoxLayout::walls, BoxMotion::all);
    add(BoxLayout::clusters, BoxMotion::all);
}

std::vector<Workload> workloads(const SuiteOptions& options) {
    std::vector<Workload> list;
    add_main_workloads(options, list);
    add_motions(options.is_quick() ? 1000 : 10'000, options, list);
    if (!options.is_long || options.is_quick()) return list;
    add_motions(100'000, options, list);
    constexpr std::size_t million = 1'000'000;
    if (options.wants(million))
        list.push_back({{BoxLayout::dense, BoxMotion::hundredth, million, frame_count(million, options)}, false});
    return list;
}

std::vector<BroadMaker> engines_of(const SuiteOptions& options) {
    return options.is_main ? main_broad_engines() : broad_engines();
}

std::vector<BroadMaker> makers_for(const Workload& workload, const SuiteOptions& options) {
    const std::size_t box_count = workload.boxes.count;
    std::vector<BroadMaker> makers = options.wanted(engines_of(options));
    std::erase_if(makers, [&](const BroadMaker& maker) {
        return (!workload.is_main && std::ranges::find(motion_engines, maker.name) == motion_engines.end()) ||
               (box_count > maker.traits.count_max && !options.is_long);
    });
    // Beyond what a list of 16-bit numbers can hold, and beyond patience, for any length of run.
    std::erase_if(makers, [&](const BroadMaker& maker) {
        return box_count > 16'000 && (maker.name == "Bullet AxisSweep3" || maker.name == broad_fcl_sweep ||
                                      maker.name == "ECoDS, brute force");
    });
    return makers;
}

void add_rows(Table& table, const scenes::MovingBoxes& boxes, const BroadTruth& truth,
              const std::vector<BroadRun>& runs) {
    std::vector<double> yardstick;
    for (const BroadRun& run : runs)
        if (run.maker->name == broad_yardstick) yardstick = run.ns;
    for (const BroadRun& run : runs) {
        std::vector<std::string> row = {boxes.name, run.maker->name, run.failure};
        if (run.failure.empty())
            row = {boxes.name,
                   run.maker->name,
                   fmt::format("{:.1f}", median(run.ns)),
                   run.ns.size() < 2 ? std::string() : fmt::format("{:.0f}", spread_in_percent(run.ns)),
                   fmt::format("{:.1f}", std::ranges::max(run.frame_ns)),
                   fmt::format("{}", run.frame_count),
                   ratio_text(times_as_fast(run.ns, yardstick)),
                   fmt::format("{:.2f}", truth.pair_count / static_cast<double>(boxes.boxes.size())),
                   fmt::format("{}", run.errors.false_negatives),
                   fmt::format("{}", run.errors.false_positives)};
        row.resize(table.header.size());
        table.rows.push_back(std::move(row));
    }
}

Table empty_table(const SuiteOptions& options) {
    Table table{.title = boxes_title, .text_columns = 2, .is_summary = true};
    table.header = {"boxes",  "engine",    "ns/box/frame", "spread %", "slowest",
                    "frames", "times FCL", "pairs/box",    "false -",  "false +"};
    table.notes = {
        fmt::format("Processor time: means over all frames in which boxes may move, the first one too, {}{}; 20 ms "
                    "untimed before each; each engine in a process of its own.",
                    medians_of(options.repetition_count),
                    options.is_long || options.repetition_count == 1 ? "" : " (100k: one)"),
        "Slowest: the frame that took longest, ns/box; of each frame the least time of all repetitions counts.",
        fmt::format("Frames: so many were timed. An engine that needs more than {:.1f} s for all of them is timed over "
                    "fewer, and once ({}: {:.1f} s, and as often as the others).",
                    turn_seconds(options), broad_yardstick, 3 * turn_seconds(options)),
        "Trees that are refitted and never rebuilt grow worse with every jump: with 1 % teleport FCL's time a frame "
        "rises "
        "as long as one waits.",
        fmt::format("The full list of pairs is delivered in every frame. Times FCL: how many times as fast as {}.",
                    broad_yardstick),
        fmt::format("Warning: {} was seen to lose pairs, and to report false ones, of boxes that keep their size but "
                    "for the rounding of "
                    "their ends, and with bodies that turn to crash or not to end, too. It is no yardstick.",
                    broad_fcl_sweep),
        "False -, false +: false negatives and false positives, pairs in the first, middle and last frame that the "
        "engine runs, against all pairs (100k: "
        "CGAL's box intersection)."};
    return table;
}

}  // namespace

SuiteResult run_broad(const SuiteOptions& options) {
    SuiteResult result;
    Table table = empty_table(options);
    const std::vector<Workload> list = workloads(options);
    {
        process::Progress progress("broad", list.size());
        for (const Workload& workload : list) {
            const scenes::MovingBoxes boxes = scenes::moving_boxes(workload.boxes);
            const BroadTruth truth = find_pairs(boxes);
            const std::vector<BroadMaker> makers = makers_for(workload, options);
            const bool is_repeated = options.is_long || workload.boxes.count <= 16'000;
            const std::size_t repetitions = is_repeated ? options.repetition_count : 1;
            const std::vector<BroadRun> runs =
                measure_broad(boxes, truth, makers, {repetitions, turn_seconds(options)});
            add_rows(table, boxes, truth, runs);
            for (const BroadRun& run : runs)
                result.is_right &= !run.maker->is_ecods || (run.failure.empty() && run.errors.count() == 0);
            progress.step();
        }
    }
    print(table, options);
    const Table swaps = swap_table(options.is_quick() ? 1000 : 16'000, options.is_quick() ? 3 : 20);
    print(swaps, options);
    result.sections.push_back(
        {"Boxes only",
         {"Dense: about 5 partners a box; sparse: 0.3; flat pile: one layer, about 5. Every box "
          "moves by 1 % of its size in each frame, unless the name says otherwise. Walls: dense, with some plates half "
          "as wide as the cube. Clusters: about 15 partners. Swarm: dense, in a ball that turns by "
          "0.9 degrees or flies five sizes a frame. What comes and goes is removed and added."},
         {table, swaps,
          use_table("How each engine is used", engines_of(options),
                    "Taking the boxes in, and the first list, are outside the times. All bounds are floats.")},
         {}});
    return result;
}

}  // namespace ecods::bench
