#include "suites/system_measure.hpp"

#include <algorithm>

#include "harness/frame_runs.hpp"
#include "harness/judge.hpp"
#include "harness/turns.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

// Values of a turn: milliseconds of all frames after the first, calls, false negatives, false positives.
process::Contained::Run start_frames(const SceneMaker& maker, const scenes::Scene& scene, const SystemTruth& truth) {
    return [&, is_first = true]() mutable -> std::vector<double> {
        warm_up(maker, scene);
        const std::unique_ptr<SceneEngine> engine = maker.set_up(scene);
        engine->run_frame({});
        double ms = 0, calls = 0;
        Errors errors;
        for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
            if (frame > 0) {
                ms += nanoseconds_of_frame(*engine, std::span(scene.frames[frame - 1].moves)) / 1e6;
                calls += static_cast<double>(engine->candidate_count());
            }
            if (is_first) errors += compare(ascending(engine->pairs()), truth.hits[frame]);
        }
        is_first = false;
        return {ms, calls, static_cast<double>(errors.false_negatives), static_cast<double>(errors.false_positives)};
    };
}

}  // namespace

double SystemTruth::hits_per_frame() const {
    std::size_t count = 0;
    for (std::size_t frame = 1; frame < hits.size(); ++frame) count += hits[frame].size();
    return static_cast<double>(count) / static_cast<double>(hits.size() - 1);
}

SystemTruth find_hits(const scenes::Scene& scene, std::size_t judged_count, const std::string& label) {
    SystemTruth truth;
    const std::unique_ptr<SceneEngine> engine = set_up_world(scene, BroadPhaseKind::sweep_and_prune);
    for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
        engine->run_frame(frame == 0 ? std::span<const scenes::Move>() : scene.frames[frame - 1].moves);
        truth.hits.push_back(ascending(engine->pairs()));
    }
    scenes::Scene start = scene;
    start.frames.resize(std::min(start.frames.size(), judged_count - 1));
    const Truth exact = ask_oracle(start, Detail::hits_only, label);
    truth.judged_count = exact.hits.size();
    for (std::size_t frame = 0; frame < exact.hits.size(); ++frame) {
        std::vector<IndexPair> hits = exact.pairs_of(frame);
        truth.wrong_count += compare(truth.hits[frame], hits).count();
        truth.hits[frame] = std::move(hits);
    }
    return truth;
}

std::vector<SystemRun> measure_systems(const scenes::Scene& scene, const SystemTruth& truth,
                                       const std::vector<SceneMaker>& makers, std::size_t repetition_count) {
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    std::vector<SystemRun> runs;
    for (const SceneMaker& maker : makers) {
        runs.push_back({.name = maker.name, .is_ecods = maker.is_ecods});
        children.emplace_back([&] { return start_frames(maker, scene, truth); }, turn_limit);
    }
    const auto frames = static_cast<double>(scene.frames.size());
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            const process::Outcome outcome = children[i].run();
            runs[i].failure = outcome.failure;
            if (!outcome.is_right()) continue;
            const std::vector<double>& values = outcome.values;
            runs[i].ms.push_back(values[0] / frames);
            runs[i].calls = values[1] / frames;
            if (repetition == 0)
                runs[i].errors = {static_cast<std::size_t>(values[2]), static_cast<std::size_t>(values[3])};
        }
    }
    return runs;
}

}  // namespace ecods::bench
