// How far some bodies of a world are from each other, after every update.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/checks/truth.hpp"
#include "judge/distance_truth.hpp"

namespace ecods::fuzz {

class DistanceQuestions {
  public:
    // Chooses pairs of bodies, of which one has changed if any has, and asks the oracle about them.
    void choose(const World& world, const Truth& truth, std::uint32_t seed);

    // Asks the library about them, in any floating-point environment, with one memory and one witness for all bodies
    // and all frames. Throws CheckFailed.
    void check(Counters& counters);

  private:
    struct Chosen {
        std::shared_ptr<const Shape> a, b;  // a world may let them go
        judge::DistanceTruth truth;
    };
    std::vector<Chosen> chosen_;
    QueryMemory memory_;
    PairWitness witness_;
};

}  // namespace ecods::fuzz
