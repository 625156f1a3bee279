// The broad phases of ECoDS by name, for suites that run each of them. A new one joins here.
#pragma once

#include <array>

#include "ecods/broad_phase.hpp"

namespace ecods::bench {

struct NamedBroadPhase {
    BroadPhaseKind kind;
    const char* name;
};

inline constexpr std::array broad_phase_kinds{
    NamedBroadPhase{BroadPhaseKind::automatic, "automatic"},
    NamedBroadPhase{BroadPhaseKind::kept_candidates, "kept candidates"},
    NamedBroadPhase{BroadPhaseKind::sweep_and_prune, "sweep and prune"},
    NamedBroadPhase{BroadPhaseKind::brute_force, "brute force"},
};

}  // namespace ecods::bench
