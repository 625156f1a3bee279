// The pairs that a search found, as a list.
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

// Working memory of making lists, for the next one.
struct ListingMemory {
    struct Next {
        std::uint32_t first = 0, second = 0;  // where the next pair goes of which this is that number
    };
    std::vector<Next> next;  // by number
    ProxyPairs by_second;
};

// Makes `list` the pairs that for_each(visit) gives to visit(a, b), the same ones each time, in ascending order.
// Numbers are below `end`. Cost: proportional to pairs and numbers.
//
// By the second numbers and then by the first ones, as digits are sorted: counted, and put where those of a number
// begin. Sorting the few pairs of each first number by comparing them costs more, since nobody can foretell how that
// ends.
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
    if (list.capacity() < by_second.size()) {  // nothing in it is to be copied, and the next one is a little longer
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
