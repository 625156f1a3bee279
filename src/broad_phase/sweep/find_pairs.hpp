// Overlapping pairs from scratch, without temporal coherence.
#pragma once

#include <cstdint>
#include <span>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Appends the pairs that overlap and of which at least one is `chosen`, in no order, each once. All chosen proxies
// are present. Returns the number of box tests. Cost: sorting the chosen into trees, and a query for each box present.
std::uint64_t find_pairs_of(std::span<const ProxyIndex> chosen, const ProxyTable& table, ProxyPairs& found);

}  // namespace ecods
