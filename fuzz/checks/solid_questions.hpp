// Bodies that are solids, after every update: how two of them are to each other and where points are, by the oracle;
// and what worlds say of all of them, by asking one by one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/checks/truth.hpp"
#include "judge/solid_truth.hpp"

namespace ecods::fuzz {

class SolidQuestions {
  public:
    // Chooses two solids whose boxes overlap, if there are any, one of them changed if any such has, and asks the
    // oracle about them.
    void choose(const World& world, const Truth& truth, std::uint32_t seed);

    // Asks the library about them, in any floating-point environment, with one memory for all bodies and all frames.
    // Throws CheckFailed.
    void check(Counters& counters);

  private:
    struct Chosen {
        std::shared_ptr<const Solid> a, b;  // a world may let them go
        judge::SolidTruth truth;
    };
    std::vector<Chosen> chosen_;
    QueryMemory memory_;
};

// Worlds that were given the same calls, and updated since: their pairs of solids, and the bodies that contain some
// points that the seed chooses, are what the first one's bodies say. Throws CheckFailed.
void check_solids(std::span<World* const> worlds, std::uint32_t seed, Counters& counters);

}  // namespace ecods::fuzz
