#include "suites/system_measure.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "harness/judge.hpp"
#include "harness/stopwatch.hpp"
#include "harness/touch_pages.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

using Hits = std::vector<IndexPair>;
constexpr std::chrono::seconds turn_limit{300};

std::size_t count_difference(const Hits& from, const Hits& what) {
    Hits difference;
    std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
    return difference.size();
}

// Some frames first, untimed (harness/stopwatch.hpp says why).
void warm_up(const EngineMaker& maker, const scenes::Scene& scene) {
    const std::unique_ptr<Engine> engine = maker.set_up(scene);
    engine->run_frame({});
    const Stopwatch watch;
    for (const scenes::Frame& frame : scene.frames) {
        if (watch.nanoseconds() > warm_up_ns) break;
        engine->run_frame(frame.moves);
    }
}

// Values of a turn: milliseconds of all frames after the first, calls, false negatives, false positives.
process::Contained::Run start_frames(const EngineMaker& maker, const scenes::Scene& scene, const SystemTruth& truth) {
    return [&, is_first = true]() mutable -> std::vector<double> {
        warm_up(maker, scene);
        const std::unique_ptr<Engine> engine = maker.set_up(scene);
        double ms = 0, calls = 0;
        std::size_t false_negatives = 0, false_positives = 0;
        for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
            const std::span<const scenes::Move> moves =
                frame == 0 ? std::span<const scenes::Move>() : scene.frames[frame - 1].moves;
            touch_pages(moves);
            const Stopwatch watch;
            engine->run_frame(moves);
            if (frame > 0) {
                ms += watch.nanoseconds() / 1e6;
                calls += static_cast<double>(engine->candidate_count());
            }
            if (!is_first) continue;
            const Hits hits = engine->hits();
            false_negatives += count_difference(truth.hits[frame], hits);
            false_positives += count_difference(hits, truth.hits[frame]);
        }
        is_first = false;
        return {ms, calls, static_cast<double>(false_negatives), static_cast<double>(false_positives)};
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
    const std::unique_ptr<Engine> engine = set_up_world(scene, BroadPhaseKind::sweep_and_prune);
    for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
        engine->run_frame(frame == 0 ? std::span<const scenes::Move>() : scene.frames[frame - 1].moves);
        truth.hits.push_back(engine->hits());
    }
    scenes::Scene start = scene;
    start.frames.resize(std::min(start.frames.size(), judged_count - 1));
    const Truth exact = ask_oracle(start, Detail::hits_only, label);
    truth.judged_count = exact.hits.size();
    for (std::size_t frame = 0; frame < exact.hits.size(); ++frame) {
        Hits hits;
        for (const TrueHit& hit : exact.hits[frame]) hits.push_back(hit.pair);
        truth.wrong_count += count_difference(hits, truth.hits[frame]) + count_difference(truth.hits[frame], hits);
        truth.hits[frame] = std::move(hits);
    }
    return truth;
}

std::vector<SystemRun> measure_systems(const scenes::Scene& scene, const SystemTruth& truth,
                                       std::span<const EngineMaker> makers, std::size_t repetition_count) {
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    std::vector<SystemRun> runs(makers.size());
    for (std::size_t i = 0; i < makers.size(); ++i) {
        runs[i].name = makers[i].name;
        runs[i].is_ecods = makers[i].is_ecods;
        children.emplace_back([&, i] { return start_frames(makers[i], scene, truth); }, turn_limit);
    }
    const auto frames = static_cast<double>(scene.frames.size());
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            const process::Outcome outcome = children[i].run();
            runs[i].failure = outcome.failure;
            if (!outcome.is_right()) continue;
            runs[i].calls = outcome.values[1] / frames;
            runs[i].ms.push_back(outcome.values[0] / frames);
            if (repetition == 0) {
                runs[i].false_negatives = static_cast<std::size_t>(outcome.values[2]);
                runs[i].false_positives = static_cast<std::size_t>(outcome.values[3]);
            }
        }
    }
    return runs;
}

}  // namespace ecods::bench
