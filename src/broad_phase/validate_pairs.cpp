#include "broad_phase/validate_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "broad_phase/brute_force.hpp"
#include "ecods/error.hpp"

namespace ecods {

namespace {

bool is_strictly_ascending(const ProxyPairs& pairs) {
    return std::adjacent_find(pairs.begin(), pairs.end(),
                              [](const ProxyPair& a, const ProxyPair& b) { return !(a < b); }) == pairs.end();
}

std::string text(const ProxyPair& pair) {
    return std::to_string(pair.a) + ", " + std::to_string(pair.b);
}

}  // namespace

void validate_pairs(const ProxyTable& table, const ProxyPairs& pairs, const ProxyPairs& began,
                    const ProxyPairs& ended) {
    for (const ProxyPairs* list : {&pairs, &began, &ended}) {
        if (!is_strictly_ascending(*list)) throw BrokenInvariant("broad phase: a list of pairs is not ascending");
    }
    ProxyPairs expected;
    all_pairs(table, expected);
    for (std::size_t i = 0; i < std::max(pairs.size(), expected.size()); ++i) {
        if (i == expected.size() || (i < pairs.size() && pairs[i] < expected[i])) {
            throw BrokenInvariant("broad phase: false positive " + text(pairs[i]));
        }
        if (i == pairs.size() || expected[i] < pairs[i]) {
            throw BrokenInvariant("broad phase: false negative " + text(expected[i]));
        }
    }
    if (!std::includes(pairs.begin(), pairs.end(), began.begin(), began.end())) {
        throw BrokenInvariant("broad phase: a pair began that is not here");
    }
    for (const ProxyPair& pair : ended) {
        if (std::binary_search(pairs.begin(), pairs.end(), pair) &&
            !std::binary_search(began.begin(), began.end(), pair)) {
            throw BrokenInvariant("broad phase: pair " + text(pair) + " ended and is here");
        }
    }
}

}  // namespace ecods
