// Ends that come into and go from a list.
#pragma once

#include <span>

#include "broad_phase/changes/proxy_table.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// Takes the ends of the removed proxies out. Cost: one pass, however many there are.
void remove_ends(EndpointList& ends, const ProxyTable& table);

// Merges the ends of the added proxies into a sorted list. Cost: sorting them, and one pass.
void insert_ends(EndpointList& ends, int axis, std::span<const ProxyIndex> added, const BoxHistory& boxes);

}  // namespace ecods
