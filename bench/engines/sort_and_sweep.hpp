// All pairs from scratch at every update: nothing is kept of the last one but the boxes and the list of pairs.
#pragma once

#include <array>
#include <vector>

#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "broad_phase/scratch/grid_sweep.hpp"
#include "broad_phase/scratch/list_pairs.hpp"

namespace ecods::bench {

// What the library's broad phases are measured by: its cost is the same whatever boxes do, and an update of theirs that
// costs more has kept too much. It delivers what they do: ascending pairs, and those that began and ended.
class SortAndSweep {
  public:
    // What BroadPhase promises of the calls of these names.
    void add(ProxyIndex proxy, const Aabb& box) { table_.add(proxy, box); }
    void move(ProxyIndex proxy, const Aabb& box) { table_.move(proxy, box); }
    void remove(ProxyIndex proxy) { table_.remove(proxy); }
    void update();
    const ProxyPairs& pairs() { return pairs_.sorted(); }
    const ProxyPairs& began() const noexcept { return events_.began; }
    const ProxyPairs& ended() const noexcept { return events_.ended; }

  private:
    void find(const ProxyChanges& changes);

    ProxyTable table_;
    PairEvents events_;
    PairList pairs_{events_};
    std::vector<PackedBox> lines_;  // by proxy
    GridSweep search_;
    std::vector<std::array<SlotIndex, 2>> found_;
    ProxyPairs ascending_;
    ListingMemory listing_;
};

}  // namespace ecods::bench
