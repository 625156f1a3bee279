// The definition of what a broad phase answers, and the check that it was.
#pragma once

#include <cstdint>

#include "broad_phase/pair_events.hpp"
#include "broad_phase/proxy_table.hpp"

namespace ecods {

// Makes `found` the overlapping pairs among the boxes present, ascending, by testing all. Returns the number of tests.
std::uint64_t all_pairs(const ProxyTable& table, ProxyPairs& found);

// Throws BrokenInvariant unless `pairs` are all_pairs, the events are ascending, what began is here, and what ended is
// gone or began again.
void validate_pairs(const ProxyTable& table, const ProxyPairs& pairs, const ProxyPairs& began, const ProxyPairs& ended);

}  // namespace ecods
