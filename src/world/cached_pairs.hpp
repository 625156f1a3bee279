// The pairs of the verdict cache, as the finders of pairs ask for them.
#pragma once

#include "broad_phase/changes/pair_events.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// The cache must hold the pairs of the last update, and no events that it does not know may be left.
class CachedPairs final : public PairKeeper {
  public:
    explicit CachedPairs(const VerdictCache& cache) : cache_(cache) {}

    // Cost: that of the pairs it appends.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;

    // Cost: two passes over the cache, and one over `found` and over the proxies.
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

  private:
    const VerdictCache& cache_;
};

}  // namespace ecods
