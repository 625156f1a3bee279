// World::update() out of memory at any point: the lists stay as they were, and the next update finds all.
#include "scenes/thread_executor.hpp"
#include "unit/allocation/scene.hpp"

namespace ecods::allocation::world_update_test {
namespace {

using Tested = std::tuple<BroadPhaseKind, std::size_t>;  // with so many workers; 0: no executor

class UpdateOutOfMemory : public testing::TestWithParam<Tested> {
  protected:
    static WorldOptions options() {
        const auto [kind, workers] = GetParam();
        return {.broad_phase = kind, .executor = workers == 0 ? nullptr : std::make_shared<ThreadExecutor>(workers)};
    }
    static Trial<Scene> trial_of(std::size_t body_count, double spacing, Stage stage) {
        return {.make = [=] { return Scene(options(), stage, body_count, spacing); },
                .call = [](Scene& scene) { scene.world.update(); },
                .difference = [](Scene& a, Scene& b) { return difference(a, b); },
                .go_on = [](Scene& scene) { scene.go_on(); },
                // Candidates are unspecified until an update succeeds.
                .after_failure =
                    [](Scene& a, Scene& b) {
                        WorldState expected = state_of(a.world);
                        WorldState got = state_of(b.world);
                        expected.overlapping = got.overlapping = {};
                        expected.overlapping_count = got.overlapping_count = 0;
                        expected.filtered_count = got.filtered_count = 0;
                        return difference(expected, got);
                    }};
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, UpdateOutOfMemory,
                         testing::Combine(testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                                          BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic),
                                          testing::Values(0, 3)));

TEST_P(UpdateOutOfMemory, TheNextUpdateFindsAll) {
    for (const Stage stage : stages) {
        Failures failures;
        fail_each_allocation(trial_of(32, 0.45, stage), failures);
        expect_none(failures, "update, stage " + std::to_string(static_cast<int>(stage)), 10);
    }
}

// So many pairs that tests are handed to workers. Each allocation fails in the smaller scene; here most are the same
// lines of code for more pairs, so every fifth fails.
TEST_P(UpdateOutOfMemory, TheNextUpdateFindsAllOfMany) {
    for (const Stage stage : stages) {
        Failures failures;
        fail_each_allocation(trial_of(40, 0.2, stage), failures, 5);
        expect_none(failures, "update, stage " + std::to_string(static_cast<int>(stage)), 10);
    }
}

}  // namespace
}  // namespace ecods::allocation::world_update_test
