// Broad phases of all kinds beside a world, with the boxes of its bodies: which boxes does a box, a segment, a ball
// meet?
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>

#include "ecods/broad_phase.hpp"
#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

class BoxQuestions {
  public:
    BoxQuestions();

    // Gives the broad phases the boxes that the bodies of the world have now.
    void follow(const World& world);

    // Asks all of them, between boxes and through their corners, where answers are decided by a hair. Throws
    // CheckFailed unless the answer is that of rational numbers over all boxes. Now and then a box is given another's,
    // as the broad phase answers it.
    void check(std::uint32_t seed, Counters& counters);

  private:
    template <class Question, class Meets>
    void require(const char* name, const Question& question, Meets meets, Counters& counters);
    Aabb any_box(scenes::Random& random) const;
    Vec3 any_corner(scenes::Random& random) const;
    void give_own_answer(scenes::Random& random);

    std::array<std::unique_ptr<BroadPhase>, 4> kinds_;
    std::map<BodyId, Aabb> boxes_;
};

}  // namespace ecods::fuzz
