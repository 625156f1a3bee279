// Everything that include/ecods/turn.hpp answers about a body that turns or is translated and one that goes straight to
// a pose, judged by the oracle, and the oracle by pieces of the time.
#pragma once

#include <optional>
#include <string>

#include "ecods/pose.hpp"
#include "judge/cast_truth.hpp"

namespace ecods::judge {

// Has what is true of both bodies, as TurnTruth has it of one that turns; in both orders. A translation is a turn by no
// angle for the oracle.
class TurnAndStraightTruth : public WayTruth {
  public:
    // The motion of a must not be Straight.
    TurnAndStraightTruth(const Posed<MeshShape>& a, const Motion& motion_of_a, const Moving<MeshShape>& b);

    // Nothing, or what pieces of the time say against the first time. Slow: for few triangles.
    std::optional<std::string> contradiction() const;

  private:
    // `swapped` is what is expected of b asked with a.
    void add(const std::string& name, double max_time, const std::optional<FirstContact>& expected,
             const std::optional<FirstContact>& swapped);

    Posed<MeshShape> a_, b_;
    Motion motion_of_a_, motion_of_b_;
    oracle::TurningSoup of_a_;
    oracle::MovingSoup of_b_;
};

}  // namespace ecods::judge
