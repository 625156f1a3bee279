// Convex polytopes that move in a box: all distances below their size, frame by frame.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "engines/polytopes_engine.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "harness/turns.hpp"
#include "oracle/convex.hpp"
#include "process/progress.hpp"
#include "scenes/moving_polytopes.hpp"
#include "suites/parts.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

constexpr double diameter = 2;  // the diameter of the balls around them, and the limit
constexpr double frames_yardstick_error = 1e-6;

struct FramesRun {
    const PolytopesMaker* maker = nullptr;
    std::unique_ptr<PolytopesEngine> engine = nullptr;
    std::vector<double> frame_ms = {};  // of one repetition
    std::vector<double> mean_ms = {};   // of each repetition
    std::vector<double> worst_ms = {};
    std::size_t asked_count = 0, pair_count = 0;  // in all frames of one repetition
    std::size_t missing = 0, extra = 0, off = 0;  // beside those of ECoDS
};

struct Frames {
    std::size_t body_count, frame_count, judged_a_frame;
};

// Pairs at the limit, to within the yardstick's precision, may be in or out.
void compare(FramesRun& run, const std::vector<NearPair>& own, const std::vector<NearPair>& answered) {
    std::map<IndexPair, double> left;
    for (const NearPair& pair : own) left[pair.bodies] = pair.distance;
    const auto is_clear = [](double d) { return d < diameter - frames_yardstick_error; };
    for (const NearPair& pair : answered) {
        const auto at = left.find(pair.bodies);
        if (at == left.end()) {
            run.extra += is_clear(pair.distance);
            continue;
        }
        run.off += std::abs(at->second - pair.distance) > frames_yardstick_error;
        left.erase(at);
    }
    run.missing +=
        static_cast<std::size_t>(std::ranges::count_if(left, [&](const auto& pair) { return is_clear(pair.second); }));
}

// Whether so many of the pairs, spread evenly, are the oracle's.
bool is_true(const std::vector<NearPair>& pairs, const scenes::MovingPolytopes& scene, std::size_t judged_count) {
    bool is_true = true;
    const std::size_t count = std::min(judged_count, pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!is_chosen(i, pairs.size(), count)) continue;
        const auto [a, b] = pairs[i].bodies;
        const oracle::ConvexPair exact(*scene.meshes()[a], scene.poses()[a], *scene.meshes()[b], scene.poses()[b]);
        is_true &= oracle::nearest(exact.distance()) == pairs[i].distance;
    }
    return is_true;
}

// All frames once, engines taking turns in each. The first is not timed: in it engines make what they need.
void run_once(std::vector<FramesRun>& runs, const Frames& frames, bool is_judged, bool& is_right) {
    scenes::MovingPolytopes scene({.count = frames.body_count});
    const Polytopes::Workload workload{scene.meshes(), scene.poses(), diameter};
    for (FramesRun& run : runs) {
        run.engine = run.maker->set_up(workload);
        run.frame_ms.clear();
        run.asked_count = run.pair_count = run.missing = run.extra = run.off = 0;
    }
    process::Progress progress("polytopes", frames.frame_count);
    for (std::size_t frame = 0; frame <= frames.frame_count; ++frame) {
        std::optional<std::vector<NearPair>> own;
        for (FramesRun& run : runs) {
            const Stopwatch watch;
            run.engine->run_frame(scene.poses());
            if (frame > 0) run.frame_ms.push_back(watch.nanoseconds() / 1e6);
            std::vector<NearPair> pairs = run.engine->pairs();
            std::ranges::sort(pairs, {}, &NearPair::bodies);
            run.asked_count += run.engine->candidate_count();
            run.pair_count += pairs.size();
            if (!run.maker->is_ecods) {
                if (own) compare(run, *own, pairs);
            } else if (!own) {
                own = pairs;
                if (is_judged) is_right &= is_true(pairs, scene, frames.judged_a_frame);
            } else {
                is_right &= *own == pairs;
            }
        }
        scene.step();
        if (frame > 0) progress.step();
    }
    for (FramesRun& run : runs) {
        run.engine.reset();
        run.mean_ms.push_back(std::accumulate(run.frame_ms.begin(), run.frame_ms.end(), 0.0) /
                              static_cast<double>(run.frame_ms.size()));
        run.worst_ms.push_back(*std::ranges::max_element(run.frame_ms));
    }
}

Table frames_table(const Frames& frames, std::size_t repetition_count) {
    Table table{
        .title = fmt::format("{} convex polytopes move in a box: all pairs nearer than their size", frames.body_count)};
    table.header = {"engine", "ms/frame", "spread %", "worst frame", "times FCL",
                    "pairs",  "asked",    "missing",  "extra",       "off by 1e-6"};
    table.notes = {
        fmt::format("{} frames, as in I-COLLIDE's experiment: polytopes of 50 faces go a twentieth of their radius a "
                    "frame and turn, in a box of which their balls fill a twentieth. Means over the frames; {}. Worst: "
                    "the dearest frame.",
                    frames.frame_count, medians_of(repetition_count)),
        "Pairs: nearer than the diameter, a frame; asked: two-body questions that found them. Missing, extra and off "
        "by 1e-6: of all frames, beside ECoDS.",
        fmt::format("In each frame {} distances of ECoDS, spread evenly over its pairs, are compared with the "
                    "oracle's, and its engines with each other.",
                    frames.judged_a_frame)};
    return table;
}

}  // namespace

std::optional<Table> convex_frames_table(const SuiteOptions& options, bool& is_right) {
    const Frames frames =
        options.is_quick() ? Frames{100, 3, 2} : Frames{1000, std::min<std::size_t>(options.frame_count, 100), 10};
    const std::vector<PolytopesMaker> makers = options.wanted(polytopes_engines());
    if (makers.empty()) return {};
    std::vector<FramesRun> runs;
    for (const PolytopesMaker& maker : makers) runs.push_back({.maker = &maker});
    for (std::size_t repetition = 0; repetition < options.repetition_count; ++repetition)
        run_once(runs, frames, repetition == 0, is_right);

    Table table = frames_table(frames, options.repetition_count);
    const auto yardstick =
        std::ranges::find_if(runs, [](const FramesRun& run) { return run.maker->name == polytopes_yardstick; });
    for (const FramesRun& run : runs) {
        const auto a_frame = [&](std::size_t count) {
            return count == 0 ? std::string() : fmt::format("{}", count / (frames.frame_count + 1));
        };
        const auto beside = [&](std::size_t count) {
            return run.maker->is_ecods ? std::string() : fmt::format("{}", count);
        };
        table.rows.push_back({run.maker->name, fmt::format("{:.3f}", median(run.mean_ms)),
                              fmt::format("{:.1f}", spread_in_percent(run.mean_ms)),
                              fmt::format("{:.3f}", median(run.worst_ms)),
                              ratio_text(yardstick == runs.end() ? 0 : times_as_fast(run.mean_ms, yardstick->mean_ms)),
                              a_frame(run.pair_count), a_frame(run.asked_count), beside(run.missing), beside(run.extra),
                              beside(run.off)});
    }
    return table;
}

}  // namespace ecods::bench
