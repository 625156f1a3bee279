// Every box against every other.
#pragma once

#include "broad_phase/changes/pair_finder.hpp"

namespace ecods {

// Makes `found` the overlapping pairs among the boxes present, ascending, by testing all. Returns the number of tests.
// The definition of what a broad phase answers.
std::uint64_t all_pairs(const ProxyTable& table, ProxyPairs& found);

class BruteForce final : public PairFinder {
  public:
    void build(const ProxyTable&, BroadPhaseCounts&) override {}
    void update(const FindingUpdate& update) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable&) const override {}

  private:
    ProxyPairs found_;  // of the update that runs
};

}  // namespace ecods
