// ClosestSearch keeps the closest of the pairs that are offered to it. It calls the two-body test only for pairs that
// may be closer.
#pragma once

#include <optional>

#include "broad_phase/overlap_tracker.hpp"
#include "ecods/ask.hpp"
#include "ecods/results.hpp"
#include "world/bodies.hpp"
#include "world/closest_memory.hpp"
#include "world/least.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

class ClosestSearch {
  public:
    // All arguments must outlive this object. `limit` is >= 0, or infinity.
    ClosestSearch(const Bodies& bodies, const TwoBodyTests& tests, const OverlapTracker& boxes, double limit,
                  QueryMemory& memory)
        : bodies_(bodies),
          tests_(tests),
          boxes_(boxes),
          memory_(memory),
          hints_(ClosestMemory::of(memory)),
          least_(limit) {}

    // Makes the pair the closest pair so far if it is closer than the previous one. The pair must not be filtered out;
    // it may be offered again. Returns bound().
    double offer(ProxyPair pair);

    // Returns true if a pair whose distance has this lower bound (>= 0) may win.
    bool may_win(ProxyPair pair, double lower) const noexcept { return lower <= 0 || least_.may_win(pair, lower); }

    // Returns an upper bound of the distance between the boxes of any later pair that may win. The bound is >= 0,
    // because the boxes of bodies that share points share points, too.
    double bound() const noexcept { return positive_part(least_.bound()); }

    std::optional<ClosestPair> answer();

  private:
    PairHint& hint_of(ProxyPair pair) const noexcept { return hints_.hint(bodies_.ids_of(pair)); }

    const Bodies& bodies_;
    const TwoBodyTests& tests_;
    const OverlapTracker& boxes_;
    QueryMemory& memory_;
    ClosestMemory& hints_;
    Least<ProxyPair> least_;
    std::optional<ClosestPair> known_;  // the answer, if it was computed together with the distance
};

}  // namespace ecods
