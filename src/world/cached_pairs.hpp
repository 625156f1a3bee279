// Shows the pairs of the verdict cache to the finders of overlapping pairs.
#pragma once

#include "broad_phase/changes/pair_events.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// The cache must hold the pairs of the last update, and must have taken over all events of the finder.
class CachedPairs final : public PairKeeper {
  public:
    explicit CachedPairs(const VerdictCache& cache) : cache_(cache) {}

    // Cost: proportional to the pairs of the removed boxes.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;

    // Cost: some passes over the cache, one over `found` and one over the proxies, and sorting the pairs that ended.
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

  private:
    const VerdictCache& cache_;
};

}  // namespace ecods
