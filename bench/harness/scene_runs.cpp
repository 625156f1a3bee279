#include "harness/scene_runs.hpp"

#include <gsl/gsl_statistics_double.h>

#include <chrono>
#include <stdexcept>

#include "harness/differences.hpp"
#include "harness/statistics.hpp"
#include "process/progress.hpp"

namespace ecods::bench {

namespace {

constexpr std::span<const scenes::Move> no_moves;

double milliseconds_of_frame(SceneEngine& engine, std::span<const scenes::Move> moves) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    engine.run_frame(moves);
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Appends the times to `times[frame]`; the first repetition also keeps the answers.
void repeat(const scenes::Scene& scene, const SceneMaker& maker, SceneRun& run,
            std::vector<std::vector<double>>& times) {
    const std::unique_ptr<SceneEngine> engine = maker.set_up(scene);
    const bool is_first = run.hits.empty();
    for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
        const std::span<const scenes::Move> moves =
            frame == 0 ? no_moves : std::span<const scenes::Move>(scene.frames[frame - 1].moves);
        times[frame].push_back(milliseconds_of_frame(*engine, moves));
        std::vector<IndexPair> hits = ascending(engine->pairs());
        if (is_first) {
            run.hits.push_back(std::move(hits));
            run.candidate_count += engine->candidate_count();
        } else if (hits != run.hits[frame]) {
            throw std::logic_error(maker.name + " gives another answer when it is run again");
        }
    }
    run.statistics = engine->statistics();
}

}  // namespace

double SceneRun::mean_ms() const {
    if (frame_ms.size() < 2) return frame_ms.at(0);
    return gsl_stats_mean(frame_ms.data() + 1, 1, frame_ms.size() - 1);
}

std::vector<SceneRun> measure_scene(const scenes::Scene& scene, const std::vector<SceneMaker>& engines,
                                    std::size_t repetition_count, const std::string& label) {
    std::vector<SceneRun> runs;
    for (const SceneMaker& maker : engines) runs.push_back({.name = maker.name, .is_ecods = maker.is_ecods});
    using Times = std::vector<std::vector<double>>;  // [frame][repetition]
    std::vector<Times> times(engines.size(), Times(scene.frames.size() + 1));

    process::Progress progress(label + ": runs", repetition_count * engines.size());
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t i = 0; i < engines.size(); ++i) {
            repeat(scene, engines[i], runs[i], times[i]);
            progress.step();
        }
    }
    for (std::size_t i = 0; i < engines.size(); ++i)
        for (const std::vector<double>& of_frame : times[i]) runs[i].frame_ms.push_back(median(of_frame));
    return runs;
}

}  // namespace ecods::bench
