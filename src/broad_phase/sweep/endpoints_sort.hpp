// Sorts a list of ends again after boxes moved, and finds from the swaps which pairs began and ended.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/sweep/box_history.hpp"
#include "broad_phase/sweep/endpoint.hpp"

namespace ecods {

// The data that the sorting of the three lists shares.
struct SortState {
    const BoxHistory& boxes;
    ProxyPairs& began;  // each pair that began is appended, once for each axis on which it was apart
    ProxyPairs& ended;  // each pair that ended is appended, once for each axis on which it is apart
    std::uint64_t swaps = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t swaps_max = 0;                // limit of swaps; with more, the sorting gives up
    std::vector<std::uint32_t> positions = {};  // scratch
};

// Gives the ends of the moved proxies their new coordinates and sorts the list by insertion: each pair of ends that
// changed order passes each other exactly once. If few proxies moved, ends that did not move are not visited unless
// passed. Returns false if it gave up: the list then holds the right ends in some order, and events are missing.
//
// Proof that no event is lost. A pair that overlaps now and did not before was apart on some axis, where a minimum of
// the one box passes a maximum of the other; both boxes are tested as they are now, so the pair is found to overlap. A
// pair that overlapped before and does not now is apart on some axis, where a maximum passes a minimum; both boxes are
// tested as they were. The order in which the axes are sorted does not matter.
bool sort_axis(EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state);

// Gives all ends of an axis their coordinates and sorts from scratch, without events.
void sort_axis_from_scratch(EndpointList& ends, int axis, const BoxHistory& boxes);

}  // namespace ecods
