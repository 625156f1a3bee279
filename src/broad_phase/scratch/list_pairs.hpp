// Makes a sorted list of the pairs that a search found.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/make_room.hpp"
#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// Holds scratch memory that list_each_pair() reuses.
struct ListingMemory {
    struct Next {
        std::uint32_t first = 0, second = 0;  // places of the next pair that has this number first, or second
    };
    std::vector<Next> next;  // indexed by number
    ProxyPairs by_second;
};

// Sets `list` to the pairs that for_each(visit) passes to visit(a, b), ascending. Calls for_each twice; it must pass
// the same pairs both times. All numbers must be less than `end`. Cost: proportional to `end` and the number of pairs.
//
// Uses two counting sorts, first by the second numbers and then by the first numbers. Sorting the few pairs of each
// first number by comparisons costs more, since the outcome of the comparisons is unpredictable.
template <class ForEach>
void list_each_pair(const ForEach& for_each, std::size_t end, ProxyPairs& list, ListingMemory& memory) {
    auto& [next, by_second] = memory;
    next.assign(end, {});
    for_each([&, &next = next](ProxyIndex a, ProxyIndex b) {
        ++next[std::min(a, b)].first;
        ++next[std::max(a, b)].second;
    });
    ListingMemory::Next sum;
    for (ListingMemory::Next& place : next) {
        sum.first += std::exchange(place.first, sum.first);
        sum.second += std::exchange(place.second, sum.second);
    }
    by_second.resize(sum.second);
    for_each([&, &next = next, &by_second = by_second](ProxyIndex a, ProxyIndex b) {
        by_second[next[std::max(a, b)].second++] = ordered_pair(a, b);
    });
    // Frees the old memory first, since nothing in it is needed, and reserves a little more, since the next list is
    // mostly a little longer.
    if (list.capacity() < by_second.size()) {
        release(list);
        list.reserve(by_second.size() + by_second.size() / 16);
    }
    list.resize(by_second.size());
    for (const ProxyPair& pair : by_second) list[next[pair.a].first++] = pair;
}

inline void list_pairs(std::span<const std::array<ProxyIndex, 2>> found, std::size_t end, ProxyPairs& list,
                       ListingMemory& memory) {
    const auto for_each = [&](const auto& visit) {
        for (const auto& [a, b] : found) visit(a, b);
    };
    list_each_pair(for_each, end, list, memory);
}

}  // namespace ecods
