// Which way of finding pairs suits a scene.
#pragma once

#include <cstddef>

#include "ecods/broad_phase.hpp"

namespace ecods {

// Decides from the number of boxes alone, so that runs repeat, and no scene pays for a change of mind: whatever many
// boxes do, kept candidates cost no more than sorted lists, since what comes, goes or moves takes no pass over all.
class ChooseFinder {
  public:
    // What the next update should use, of so many boxes.
    BroadPhaseKind choose(std::size_t size) noexcept;

  private:
    BroadPhaseKind kind_ = BroadPhaseKind::sweep_and_prune;
};

}  // namespace ecods
