// Gives the finders of overlapping pairs access to the pairs in the verdict cache.
#pragma once

#include "broad_phase/changes/pair_events.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// CachedPairs reads the pairs of the last update from the cache. Before it is used, the cache must have applied all
// events that the finder has reported.
class CachedPairs final : public PairKeeper {
  public:
    explicit CachedPairs(const VerdictCache& cache) : cache_(cache) {}

    // Appends to `ended` each cached pair of a removed box, once. Cost: proportional to the number of these pairs.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;

    // Sets `events` to the differences between the cached pairs and the pairs `found`, which must be sorted. Cost: some
    // passes over the cache, one over `found` and one over the proxies, and sorting the pairs that ended.
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

  private:
    const VerdictCache& cache_;
};

}  // namespace ecods
