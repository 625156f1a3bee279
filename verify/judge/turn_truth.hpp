// Everything that include/ecods/turn.hpp answers about a turning body and one at rest, judged by the oracle; the
// oracle by pieces of the time; and both by intersects() at times at which the poses, times a common factor, are
// doubles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ecods/turn.hpp"
#include "judge/cast_truth.hpp"

namespace ecods::judge {

// In hexadecimal floats.
std::string text(const Turn& turn);

// The body as the oracle takes it.
oracle::TurningSoup turning_soup(const Turning<MeshShape>& a);

// Has what is true of a body that turns, as CastTruth has it of other motions. If the pivot stays, the other body
// turns, too, the other way round: in space as the first one sees it.
class TurnTruth : public WayTruth {
  public:
    TurnTruth(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int samples = 8);

    // Nothing, or what pieces of the time say against the first time. Slow: for few triangles.
    std::optional<std::string> contradiction() const;

  private:
    void add(const std::string& name, const Turning<MeshShape>& a, const Posed<MeshShape>& b, double max_time,
             const std::optional<oracle::ExactContact>& expected);
    void add_limits(const Turning<MeshShape>& a, const Posed<MeshShape>& b);
    void add_samples(const Turning<MeshShape>& a, const Posed<MeshShape>& b, int count);

    oracle::TurningSoup of_a_;
    oracle::Soup of_b_;
};

}  // namespace ecods::judge
