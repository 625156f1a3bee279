// What the broad phases do differently: finding the pairs.
#pragma once

#include <cstddef>

#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

class PairFinder {
  public:
    virtual ~PairFinder() = default;

    // Takes over all boxes of a table that has settled. `pairs` are right already. Called once, before any update.
    virtual void build(const ProxyTable& table, BroadPhaseCounts& counts) = 0;

    // Between begin_update and end_update of `pairs`, one of which it may call by the other name: makes the events
    // those of `changes`, which are not empty.
    virtual void update(const ProxyTable& table, const ProxyChanges& changes, PairList& pairs,
                        BroadPhaseCounts& counts) = 0;

    virtual void reserve(std::size_t) {}

    virtual std::size_t bytes() const noexcept = 0;

    // Throws BrokenInvariant.
    virtual void validate(const ProxyTable& table) const = 0;
};

}  // namespace ecods
