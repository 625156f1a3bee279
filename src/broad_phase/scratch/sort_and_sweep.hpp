// All pairs from scratch at every update: nothing is kept of the last one but the boxes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/scratch/grid_sweep.hpp"

namespace ecods {

// What others are measured by: its cost is the same whatever boxes do, and an update of theirs that costs more has kept
// too much. Not a kind of broad phase for users: KeptCandidates searches in the same way where that is best.
class SortAndSweep final : public PairFinder {
  public:
    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const FindingUpdate& update) override;
    void reserve(std::size_t count) override { lines_.reserve(count); }
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable& table) const override;

  private:
    void take(std::span<const ProxyIndex> proxies, const ProxyTable& table);

    std::vector<PackedBox> lines_;  // by proxy
    GridSweep search_;
    std::vector<std::array<SlotIndex, 2>> found_;
    ProxyPairs pairs_;
};

}  // namespace ecods
