// Tests every box against every other box.
#pragma once

#include "broad_phase/changes/pair_finder.hpp"

namespace ecods {

// Sets `found` to the overlapping pairs among the boxes present, ascending, by testing all pairs. Returns the number of
// tests. The pairs found here define the right answer of every broad phase.
std::uint64_t all_pairs(const ProxyTable& table, ProxyPairs& found);

class BruteForce final : public PairFinder {
  public:
    void build(const ProxyTable&, BroadPhaseCounts&) override {}
    void update(const FindingUpdate& update) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable&) const override {}

  private:
    ProxyPairs found_;  // scratch: the pairs that the current update found
};

}  // namespace ecods
