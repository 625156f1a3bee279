#include "broad_phase/scratch/list_pairs.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ecods {

// Counted by their first numbers, put where those begin, and sorted by the second ones, of which there are few each.
void list_pairs(std::span<const std::array<SlotIndex, 2>> found, std::size_t proxy_end, ProxyPairs& list) {
    std::vector<std::size_t> next(proxy_end + 1);  // where the next pair of this first number goes
    for (const auto& [a, b] : found) ++next[std::min(a, b)];
    std::size_t sum = 0;
    for (std::size_t& place : next) sum += std::exchange(place, sum);
    list.resize(found.size());
    for (const auto& [a, b] : found) list[next[std::min(a, b)]++] = ordered_pair(a, b);
    std::size_t begin = 0;
    for (std::size_t a = 0; a < proxy_end; ++a) {
        const std::size_t end = next[a];
        if (end - begin > 1) {
            std::sort(list.begin() + static_cast<std::ptrdiff_t>(begin),
                      list.begin() + static_cast<std::ptrdiff_t>(end), is_before);
        }
        begin = end;
    }
}

}  // namespace ecods
