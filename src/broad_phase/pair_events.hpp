// Sorted lists of pairs and how they change.
#pragma once

#include <vector>

#include "broad_phase/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

using ProxyPairs = std::vector<ProxyPair>;

inline ProxyPair ordered_pair(ProxyIndex a, ProxyIndex b) noexcept {
    return a < b ? ProxyPair{a, b} : ProxyPair{b, a};
}

// Sorts, and leaves each pair once.
void normalise(ProxyPairs& pairs);

// Appends to `ended` the pairs of which a proxy was removed. Cost: one pass.
void end_removed(const ProxyPairs& pairs, const ProxyTable& table, ProxyPairs& ended);

// pairs = (pairs without `ended`) and `began`; all ascending. A pair may be in both lists and is then kept. Cost: a
// search for each change, and moving what lies behind the first.
void apply_events(const ProxyPairs& ended, const ProxyPairs& began, ProxyPairs& pairs);

// For a broad phase that has found the pairs anew: `pairs` becomes `found`. `ended`, ascending, holds the pairs that
// ended for another reason and does so still; the pairs that came and went otherwise are added to the lists, which
// end up ascending.
void replace_pairs(ProxyPairs& found, ProxyPairs& pairs, ProxyPairs& began, ProxyPairs& ended);

}  // namespace ecods
