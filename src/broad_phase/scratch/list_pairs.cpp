#include "broad_phase/scratch/list_pairs.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ecods {

// By the second numbers and then by the first ones, as digits are sorted: counted, and put where those of a number
// begin. Sorting the few pairs of each first number by comparing them costs more, since nobody can foretell how that
// ends.
void list_pairs(std::span<const std::array<SlotIndex, 2>> found, std::size_t proxy_end, ProxyPairs& list) {
    struct Next {
        std::uint32_t first = 0, second = 0;  // where the next pair goes of which this is that number
    };
    std::vector<Next> next(proxy_end);
    for (const auto& [a, b] : found) {
        ++next[std::min(a, b)].first;
        ++next[std::max(a, b)].second;
    }
    Next sum;
    for (Next& place : next) {
        sum.first += std::exchange(place.first, sum.first);
        sum.second += std::exchange(place.second, sum.second);
    }
    ProxyPairs by_second(found.size());
    for (const auto& [a, b] : found) by_second[next[std::max(a, b)].second++] = ordered_pair(a, b);
    list.resize(found.size());
    for (const ProxyPair& pair : by_second) list[next[pair.a].first++] = pair;
}

}  // namespace ecods
