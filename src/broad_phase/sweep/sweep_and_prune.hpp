// The ECoDS report's broad phase: three lists of box ends, kept sorted.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// The report keeps for each pair of boxes the number of axes on which they overlap. Here that number follows from the
// boxes of the last update and of this one, so memory is needed for boxes only, and none for pairs.
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
