// Everything that include/ecods/turn.hpp answers about two bodies that turn, judged by the oracle, and the oracle by
// pieces of the time.
#pragma once

#include <optional>
#include <string>

#include "ecods/turn.hpp"
#include "judge/cast_truth.hpp"

namespace ecods::judge {

// Has what is true of two bodies that turn, as TurnTruth has it of one; in both orders.
class BothTurnTruth : public WayTruth {
  public:
    BothTurnTruth(const Turning<MeshShape>& a, const Turning<MeshShape>& b);

    // Nothing, or what pieces of the time say against the first time. Slow: for few triangles.
    std::optional<std::string> contradiction() const;

  private:
    void add(const std::string& name, const Turning<MeshShape>& a, const Turning<MeshShape>& b, double max_time,
             const std::optional<oracle::ExactContact>& expected);

    oracle::TurningSoup of_a_, of_b_;
};

}  // namespace ecods::judge
