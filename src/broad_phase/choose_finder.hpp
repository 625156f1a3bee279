// Which way of finding pairs suits a scene.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ecods/broad_phase.hpp"

namespace ecods {

// Decides from counts, so that runs repeat.
class ChooseFinder {
  public:
    // What the next update should use, given how many boxes there are, and the counts before and after the last one.
    BroadPhaseKind choose(std::size_t size, const BroadPhaseCounts& before, const BroadPhaseCounts& after) noexcept;

  private:
    BroadPhaseKind kind_ = BroadPhaseKind::sweep_and_prune;
    std::uint64_t moved_ = 0;  // recently
    std::uint64_t steps_ = 0;  // of sweep and prune, for these
};

}  // namespace ecods
