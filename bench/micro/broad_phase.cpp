// One update of a broad phase in which all boxes have moved.
#include <benchmark/benchmark.h>

#include <memory>

#include "ecods/broad_phase.hpp"
#include "scenes/moving_boxes.hpp"

namespace {

using namespace ecods;

// The frames are run forth; back at the first one, the broad phase is a new one, outside the time.
void update(benchmark::State& state, BroadPhaseKind kind) {
    const scenes::MovingBoxes boxes =
        scenes::moving_boxes({.count = static_cast<std::size_t>(state.range(0)), .frame_count = 60});
    std::unique_ptr<BroadPhase> broad_phase;
    std::size_t frame = 0;
    for (auto _ : state) {
        if (frame == 0) {
            state.PauseTiming();
            broad_phase = make_broad_phase(kind);
            for (std::size_t i = 0; i < boxes.boxes.size(); ++i)
                broad_phase->add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
            broad_phase->update();
            state.ResumeTiming();
        }
        for (const scenes::BoxMove& move : boxes.frames[frame]) broad_phase->move(move.index, move.box);
        broad_phase->update();
        benchmark::DoNotOptimize(broad_phase->pairs().data());
        frame = (frame + 1) % boxes.frames.size();
    }
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK_CAPTURE(update, sweep_and_prune, BroadPhaseKind::sweep_and_prune)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(update, kept_candidates, BroadPhaseKind::kept_candidates)->Arg(1000)->Arg(10000);

}  // namespace
