#include "broad_phase/pair_events.hpp"

#include <algorithm>
#include <iterator>

namespace ecods {

void normalise(ProxyPairs& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void end_removed(const ProxyPairs& pairs, const ProxyTable& table, ProxyPairs& ended) {
    for (const ProxyPair& pair : pairs) {
        if (table.is_removed(pair.a) || table.is_removed(pair.b)) ended.push_back(pair);
    }
}

namespace {

// The pairs between two that end are moved as a block, so that few changes of a long list cost little.
void drop(const ProxyPairs& ended, ProxyPairs& pairs) {
    if (ended.empty()) return;
    auto read = std::lower_bound(pairs.begin(), pairs.end(), ended.front());
    auto write = read;
    for (const ProxyPair& pair : ended) {
        const auto next = std::lower_bound(read, pairs.end(), pair);
        write = std::move(read, next, write);
        read = next == pairs.end() || *next != pair ? next : next + 1;
    }
    write = std::move(read, pairs.end(), write);
    pairs.erase(write, pairs.end());
}

// From the back, so that the list can be its own destination.
void insert(const ProxyPairs& began, ProxyPairs& pairs) {
    auto old_end = static_cast<std::ptrdiff_t>(pairs.size());
    pairs.resize(pairs.size() + began.size());
    auto write = pairs.end();
    for (auto pair = began.rbegin(); pair != began.rend(); ++pair) {
        const auto first = std::lower_bound(pairs.begin(), pairs.begin() + old_end, *pair);
        write = std::move_backward(first, pairs.begin() + old_end, write);
        old_end = first - pairs.begin();
        *--write = *pair;
    }
}

}  // namespace

void apply_events(const ProxyPairs& ended, const ProxyPairs& began, ProxyPairs& pairs) {
    drop(ended, pairs);
    insert(began, pairs);
}

void replace_pairs(ProxyPairs& found, ProxyPairs& pairs, ProxyPairs& began, ProxyPairs& ended) {
    drop(ended, pairs);
    std::set_difference(found.begin(), found.end(), pairs.begin(), pairs.end(), std::back_inserter(began));
    std::set_difference(pairs.begin(), pairs.end(), found.begin(), found.end(), std::back_inserter(ended));
    std::sort(ended.begin(), ended.end());
    pairs.swap(found);
}

}  // namespace ecods
