// The ECoDS report's broad phase: three lists of box ends, kept sorted.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "broad_phase/endpoint.hpp"
#include "broad_phase/pair_events.hpp"
#include "broad_phase/proxy_table.hpp"
#include "broad_phase/sweep.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// The report keeps, for each pair of boxes, on how many axes they overlap. The same knowledge is in the boxes of the
// last update and of this one, so what is kept is one list of the pairs that overlap on all three: memory is for the
// boxes and the pairs there are.
class SweepAndPrune final : public BroadPhase {
  public:
    BroadPhaseKind kind() const noexcept override { return BroadPhaseKind::sweep_and_prune; }
    void add(ProxyIndex proxy, const Aabb& box) override { table_.add(proxy, box); }
    void move(ProxyIndex proxy, const Aabb& box) override { table_.move(proxy, box); }
    void remove(ProxyIndex proxy) override { table_.remove(proxy); }
    const Aabb& box(ProxyIndex proxy) const override { return table_.box(proxy); }
    std::size_t size() const noexcept override { return table_.size(); }
    void update() override;
    const ProxyPairs& pairs() const noexcept override { return pairs_; }
    const ProxyPairs& began() const noexcept override { return began_; }
    const ProxyPairs& ended() const noexcept override { return ended_; }
    const BroadPhaseCounts& counts() const noexcept override { return counts_; }
    void validate() const override;

  private:
    void apply(const ProxyChanges& changes);
    bool sort_axes(const ProxyChanges& changes);
    void sweep_axes(SweepScope scope, ProxyPairs& found);
    std::uint64_t swaps_max();

    ProxyTable table_;
    std::array<EndpointList, 3> axes_;
    ProxyPairs pairs_;
    ProxyPairs began_;
    ProxyPairs ended_;
    BroadPhaseCounts counts_;
    std::vector<std::uint32_t> positions_;  // working memory of sort_axis
    std::uint64_t axis_overlaps_ = 0;       // pairs that overlap on the best axis, when last counted
    std::uint64_t swaps_when_counted_ = 0;
};

}  // namespace ecods
