#include "broad_phase/sweep/endpoints_sort.hpp"

#include <algorithm>
#include <cstddef>

namespace ecods {
namespace {

// Appends the pair of two boxes to state.began or state.ended if the pair began or ended. One end is a minimum, the
// other a maximum, and they have changed order: `left` now comes before `right`.
void judge_swap(const Endpoint& left, const Endpoint& right, SortState& state) {
    const ProxyIndex a = left.proxy();
    const ProxyIndex b = right.proxy();
    ++state.box_tests;
    if (right.is_max()) {
        if (overlap(state.boxes.now(a), state.boxes.now(b))) state.began.push_back(ordered_pair(a, b));
    } else {
        if (overlap(state.boxes.before(a), state.boxes.before(b))) state.ended.push_back(ordered_pair(a, b));
    }
}

// Inserts ends[i] into the sorted ends before it, and tests the pairs of a minimum and a maximum that change order.
void sink(EndpointList& ends, std::size_t i, SortState& state) {
    const Endpoint end = ends[i];
    const std::size_t start = i;
    while (i > 0 && end < ends[i - 1]) {
        // Two minima, or two maxima, that pass each other change no pair.
        if (((end.tag ^ ends[i - 1].tag) & Endpoint::max_bit) != 0) judge_swap(end, ends[i - 1], state);
        ends[i] = ends[i - 1];
        --i;
    }
    ends[i] = end;
    state.swaps += start - i;
}

void refresh(Endpoint& end, int axis, const BoxHistory& boxes) {
    const KeyBox& box = boxes.now(end.proxy());
    end.key = end.is_max() ? box.max[axis] : box.min[axis];
}

bool sort_all(EndpointList& ends, int axis, SortState& state) {
    for (Endpoint& end : ends) refresh(end, axis, state.boxes);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        sink(ends, i, state);
        if (state.swaps > state.swaps_max) return false;
    }
    return true;
}

// Sets state.positions to the positions of the ends of the moved boxes, ascending. Call it before the first coordinate
// changes, since binary search needs a sorted list.
void find_positions(const EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state) {
    state.positions.clear();
    for (const ProxyIndex proxy : moved) {
        const KeyBox& before = state.boxes.before(proxy);
        for (const Endpoint& end : {min_end(before, proxy, axis), max_end(before, proxy, axis)}) {
            const auto at = std::lower_bound(ends.begin(), ends.end(), end);
            state.positions.push_back(static_cast<std::uint32_t>(at - ends.begin()));
        }
    }
    std::sort(state.positions.begin(), state.positions.end());
}

bool sort_some(EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state) {
    find_positions(ends, axis, moved, state);
    for (const std::uint32_t position : state.positions) refresh(ends[position], axis, state.boxes);
    std::size_t sorted = 0;  // ends before this position are sorted
    for (const std::uint32_t position : state.positions) {
        if (position < sorted) continue;
        // Inserts the changed end at `position` into the ends before it, which are sorted, and then each further end
        // that is out of order with the end before it. At the first end that is in order the loop stops: the ends
        // behind it are sorted up to the next changed position.
        sorted = position;
        do {
            sink(ends, sorted, state);
            if (state.swaps > state.swaps_max) return false;
            ++sorted;
        } while (sorted < ends.size() && ends[sorted] < ends[sorted - 1]);
    }
    return true;
}

}  // namespace

bool sort_axis(EndpointList& ends, int axis, std::span<const ProxyIndex> moved, SortState& state) {
    // A binary search costs about as much as scanning ten ends.
    constexpr std::size_t ends_per_search = 10;
    const bool few = 2 * moved.size() * ends_per_search < ends.size();
    return few ? sort_some(ends, axis, moved, state) : sort_all(ends, axis, state);
}

void sort_axis_from_scratch(EndpointList& ends, int axis, const BoxHistory& boxes) {
    for (Endpoint& end : ends) refresh(end, axis, boxes);
    std::sort(ends.begin(), ends.end());
}

}  // namespace ecods
