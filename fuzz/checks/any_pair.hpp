// Pairs of bodies with meshes, drawn for questions that are too dear to be asked of all.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "fuzz/checks/truth.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

// Nobody asks about bodies with shapes of the caller's own. It refers to the bodies of the truth.
class AnyPair {
  public:
    AnyPair(const World& world, const Truth& truth);

    // The first one has changed, if any has. Nothing: there are not two bodies, one was drawn twice, or they have more
    // pairs of triangles.
    std::optional<std::array<const TrueBody*, 2>> draw(scenes::Random& random, std::size_t triangle_pairs_max) const;

  private:
    std::vector<const TrueBody*> all_, changed_;
};

}  // namespace ecods::fuzz
