// Every box against every other.
#pragma once

#include "broad_phase/pair_events.hpp"
#include "broad_phase/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

class BruteForce final : public BroadPhase {
  public:
    BroadPhaseKind kind() const noexcept override { return BroadPhaseKind::brute_force; }
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
    ProxyTable table_;
    ProxyPairs pairs_;
    ProxyPairs began_;
    ProxyPairs ended_;
    ProxyPairs found_;  // of the update that runs
    BroadPhaseCounts counts_;
};

}  // namespace ecods
