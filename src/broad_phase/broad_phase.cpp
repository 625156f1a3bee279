#include "ecods/broad_phase.hpp"

#include "broad_phase/brute_force.hpp"
#include "broad_phase/sweep_and_prune.hpp"

namespace ecods {

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind) {
    if (kind == BroadPhaseKind::brute_force) return std::make_unique<BruteForce>();
    return std::make_unique<SweepAndPrune>();
}

}  // namespace ecods
