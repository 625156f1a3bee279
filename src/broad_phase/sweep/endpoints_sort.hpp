// Re-sorting a list of ends after boxes moved, and what that shows of pairs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// What the sorting of the three lists has in common.
struct SortState {
    const BoxHistory& boxes;
    ProxyPairs& began;  // each pair that began is appended, once for each axis on which it was apart
    ProxyPairs& ended;  // each pair that ended is appended, once for each axis on which it is apart
    std::uint64_t swaps = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t swaps_max = 0;                // give up when there were more
    std::vector<std::uint32_t> positions = {};  // working memory
};

// Gives the ends of the moved proxies their new coordinates and sorts the list by insertion: each pair of ends that
// changed order passes each other exactly once. No other end is looked at when few proxies moved. Returns false when
// it gave up: the list then holds the right ends in some order, and events are missing.
//
// Why nothing is lost. A pair that overlaps now and did not before was apart on some axis, where a minimum of the
// one passes a maximum of the other; both boxes are judged as they are now, so it is seen to overlap. A pair
// that overlapped before and does not now is apart on some axis, where a maximum passes a minimum; both are judged
// as they were. Which axis is sorted first does not matter.
bool sort_axis(EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state);

// Gives all ends of an axis their coordinates and sorts from scratch, without events.
void sort_axis_from_scratch(EndpointList& ends, int axis, const BoxHistory& boxes);

}  // namespace ecods
