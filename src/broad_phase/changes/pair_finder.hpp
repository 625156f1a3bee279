// The interface of the ways of finding pairs, in which the broad phases differ.
#pragma once

#include <cstddef>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// The input and output of an update.
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

    // Takes over all boxes of a settled table, whose pairs are known. Called once, before any update.
    virtual void build(const ProxyTable& table, BroadPhaseCounts& counts) = 0;

    // Adds the events of the changes: ascending, each once.
    virtual void update(const FindingUpdate& update) = 0;

    virtual void reserve(std::size_t) {}

    virtual std::size_t bytes() const noexcept = 0;

    // Throws BrokenInvariant.
    virtual void validate(const ProxyTable& table) const = 0;
};

}  // namespace ecods
