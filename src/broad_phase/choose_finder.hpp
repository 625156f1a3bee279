// Which way of finding pairs suits a scene.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ecods/broad_phase.hpp"

namespace ecods {

// Decides from counts, so that runs repeat.
class ChooseFinder {
  public:
    // What an update had to do.
    struct Work {
        std::size_t size;     // boxes present
        std::uint64_t moved;  // boxes that moved; those that came do not count
        std::uint64_t swaps;  // of sweep and prune
    };

    // What the next update should use.
    BroadPhaseKind choose(const Work& last) noexcept;

  private:
    BroadPhaseKind kind_ = BroadPhaseKind::sweep_and_prune;
    std::uint64_t updates_ = 0;  // of the period that the sums below are about
    std::uint64_t moved_ = 0;
    std::uint64_t swaps_ = 0;
};

}  // namespace ecods
