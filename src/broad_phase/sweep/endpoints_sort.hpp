// Sorts a list of ends again after boxes moved, and finds from the swaps which pairs began and ended.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// Holds the data that the calls of sort_axis() for the three axes share.
struct SortState {
    const BoxHistory& boxes;
    ProxyPairs& began;  // each pair that began is appended, once for each axis on which it was apart
    ProxyPairs& ended;  // each pair that ended is appended, once for each axis on which it is apart
    std::uint64_t swaps = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t swaps_max = 0;                // limit of `swaps`, above which sort_axis() gives up
    std::vector<std::uint32_t> positions = {};  // scratch
};

// Gives the ends of the proxies in `moved` their new coordinates and sorts `ends` by insertion: two ends that change
// order are swapped exactly once. Finds the events at the swaps and appends them to state.began and state.ended. If few
// proxies moved, visits only their ends and the ends that these pass. Returns false if it gave up after too many swaps:
// `ends` then has the new coordinates in some order, and events are missing.
//
// Proof that no event is lost. A pair that overlaps now and did not overlap before was apart on some axis before. On
// that axis a minimum of one box passes a maximum of the other, and both boxes are tested as they are now, so the pair
// is found to overlap. A pair that overlapped before and does not overlap now is apart on some axis now. On that axis a
// maximum of one box passes a minimum of the other, and both boxes are tested as they were before. The order in which
// the axes are sorted does not matter.
bool sort_axis(EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state);

// Gives all ends their new coordinates and sorts the list of ends from scratch. Finds no events.
void sort_axis_from_scratch(EndpointList& ends, int axis, const BoxHistory& boxes);

}  // namespace ecods
