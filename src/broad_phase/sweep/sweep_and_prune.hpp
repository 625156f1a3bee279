// Implements the broad phase of the ECoDS report: keeps three lists of box ends sorted.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// The report keeps, for each pair of boxes, the number of axes on which the two overlap. This class does not: it tests
// the boxes of the last update and of this one when their ends swap, so it needs memory for boxes only, none for pairs.
class SweepAndPrune final : public PairFinder {
  public:
    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const FindingUpdate& update) override;
    void reserve(std::size_t count) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable& table) const override;

  private:
    bool sort_axes(const FindingUpdate& update);

    BoxHistory boxes_;
    std::array<EndpointList, 3> axes_;
    std::vector<std::uint32_t> positions_;  // scratch of sort_axis
};

}  // namespace ecods
