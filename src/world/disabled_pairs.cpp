#include "world/disabled_pairs.hpp"

#include <algorithm>

namespace ecods {

bool DisabledPairs::insert(ProxyPair pair) {
    if (contains(pair)) return false;
    const std::size_t end = std::size_t{std::max(pair.a, pair.b)} + 1;
    if (counts_.size() < end) counts_.resize(end);
    const auto first = pairs_.emplace(pair.a, pair.b).first;
    try {
        pairs_.emplace(pair.b, pair.a);
    } catch (...) {
        pairs_.erase(first);
        throw;
    }
    ++counts_[pair.a];
    ++counts_[pair.b];
    return true;
}

bool DisabledPairs::erase(ProxyPair pair) noexcept {
    if (!contains(pair)) return false;
    pairs_.erase({pair.a, pair.b});
    pairs_.erase({pair.b, pair.a});
    --counts_[pair.a];
    --counts_[pair.b];
    return true;
}

void DisabledPairs::forget(ProxyIndex proxy) noexcept {
    if (count_of(proxy) == 0) return;
    const auto begin = pairs_.lower_bound({proxy, 0});
    auto end = begin;
    for (; end != pairs_.end() && end->first == proxy; ++end) {
        pairs_.erase({end->second, proxy});
        --counts_[end->second];
    }
    pairs_.erase(begin, end);
    counts_[proxy] = 0;
}

std::vector<ProxyPair> DisabledPairs::list() const {
    std::vector<ProxyPair> result;
    for (const auto& [a, b] : pairs_) {
        if (a < b) result.push_back({a, b});
    }
    return result;
}

std::size_t DisabledPairs::memory_bytes() const noexcept {
    // A node of a red-black tree holds its value, three pointers and a colour.
    constexpr std::size_t node_bytes = sizeof(std::pair<ProxyIndex, ProxyIndex>) + 4 * sizeof(void*);
    return pairs_.size() * node_bytes + counts_.capacity() * sizeof(std::uint32_t);
}

}  // namespace ecods
