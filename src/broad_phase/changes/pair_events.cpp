#include "broad_phase/changes/pair_events.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace ecods {

// Sorts by radix, least significant digit first, and skips digits that are equal in all pairs. For many pairs this is
// faster than a sort by comparisons, whose branches are unpredictable.
void sort_pairs(ProxyPairs& pairs) {
    constexpr std::size_t few = 96;
    constexpr unsigned digit_bits = 8;
    constexpr std::size_t digit_count = std::size_t{1} << digit_bits;
    if (pairs.size() < few) {
        std::sort(pairs.begin(), pairs.end(), is_before);
        return;
    }
    if (std::is_sorted(pairs.begin(), pairs.end(), is_before)) return;
    std::uint64_t varying = 0;
    for (const ProxyPair& pair : pairs) varying |= rank_of(pair) ^ rank_of(pairs.front());
    ProxyPairs spare(pairs.size());
    for (unsigned shift = 0; shift < 64; shift += digit_bits) {
        if ((varying >> shift) % digit_count == 0) continue;
        std::array<std::size_t, digit_count> next{};  // place of the next pair with this digit
        for (const ProxyPair& pair : pairs) ++next[(rank_of(pair) >> shift) % digit_count];
        std::size_t sum = 0;
        for (std::size_t& place : next) sum += std::exchange(place, sum);
        for (const ProxyPair& pair : pairs) spare[next[(rank_of(pair) >> shift) % digit_count]++] = pair;
        pairs.swap(spare);
    }
}

void normalise(ProxyPairs& pairs) {
    sort_pairs(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace ecods
