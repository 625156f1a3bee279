// Finding pairs along a sorted list of ends, for boxes that have no past.
#pragma once

#include <array>
#include <cstdint>

#include "broad_phase/endpoint.hpp"
#include "broad_phase/pair_events.hpp"
#include "broad_phase/proxy_table.hpp"

namespace ecods {

// An axis, and the number of pairs of boxes that overlap on it.
struct SweepAxis {
    int axis = 0;
    std::uint64_t overlaps = 0;
};

// The axis on which the fewest pairs overlap. Cost: one pass over each list.
SweepAxis choose_sweep_axis(const std::array<EndpointList, 3>& axes);

enum class SweepScope { all_pairs, pairs_of_added };

// Appends to `found` the overlapping pairs, or those of which at least one proxy was added since the last update, in
// no order, each once. `ends` is the sorted list of the axis. Returns the number of box tests, at most the number of
// pairs that overlap on the axis.
std::uint64_t sweep(const EndpointList& ends, int axis, const ProxyTable& table, SweepScope scope, ProxyPairs& found);

}  // namespace ecods
