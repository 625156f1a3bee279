// Declares the interface of pair finders. Broad phases differ only in their finders.
#pragma once

#include <cstddef>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// Holds the input of an update (table, changes and keeper) and its output (events and counts).
struct FindingUpdate {
    const ProxyTable& table;
    const ProxyChanges& changes;  // not empty
    PairKeeper& keeper;
    PairEvents& events;  // empty when the update begins
    BroadPhaseCounts& counts;
};

class PairFinder {
  public:
    virtual ~PairFinder() = default;

    // Takes over all boxes of `table`, which must be settled; the keeper has their pairs already. Call at most once,
    // before any update.
    virtual void build(const ProxyTable& table, BroadPhaseCounts& counts) = 0;

    // Sets update.events to the pairs that began and ended: two ascending lists without duplicates.
    virtual void update(const FindingUpdate& update) = 0;

    virtual void reserve(std::size_t) {}

    virtual std::size_t bytes() const noexcept = 0;

    // Throws BrokenInvariant if the finder's data does not fit the table.
    virtual void validate(const ProxyTable& table) const = 0;
};

}  // namespace ecods
