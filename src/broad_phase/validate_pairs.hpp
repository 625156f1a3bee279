// The check that a broad phase answered what it should.
#pragma once

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Throws BrokenInvariant unless `pairs` are all_pairs, the events are ascending, what began is here, and what ended is
// gone or began again.
void validate_pairs(const ProxyTable& table, const ProxyPairs& pairs, const ProxyPairs& began, const ProxyPairs& ended);

}  // namespace ecods
