// What the broad phases do differently: finding the pairs.
#pragma once

#include <cstddef>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// What an update has to work with.
struct FindingUpdate {
    const ProxyTable& table;
    const ProxyChanges& changes;  // not empty
    PairKeeper& keeper;
    PairEvents& events;  // empty at first
    BroadPhaseCounts& counts;
};

class PairFinder {
  public:
    virtual ~PairFinder() = default;

    // Takes over all boxes of a table that has settled, and of which the pairs are known. Called once, before any
    // update.
    virtual void build(const ProxyTable& table, BroadPhaseCounts& counts) = 0;

    // Makes the events those of the changes: ascending, and each once.
    virtual void update(const FindingUpdate& update) = 0;

    virtual void reserve(std::size_t) {}

    virtual std::size_t bytes() const noexcept = 0;

    // Throws BrokenInvariant.
    virtual void validate(const ProxyTable& table) const = 0;
};

}  // namespace ecods
