// The pairs that began and ended with an update, and the interface to the keeper of the pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/proxy_table.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

using ProxyPairs = std::vector<ProxyPair>;

inline ProxyPair ordered_pair(ProxyIndex a, ProxyIndex b) noexcept {
    return a < b ? ProxyPair{a, b} : ProxyPair{b, a};
}

// Returns a number that orders as the pair does.
constexpr std::uint64_t rank_of(const ProxyPair& pair) noexcept {
    return std::uint64_t{pair.a} << 32 | pair.b;
}

// Orders pairs by their ranks; a function object, so that algorithms inline it.
inline constexpr auto is_before = [](const ProxyPair& a, const ProxyPair& b) { return rank_of(a) < rank_of(b); };

// Sorts ascending.
void sort_pairs(ProxyPairs& pairs);

// Sorts, and removes duplicates.
void normalise(ProxyPairs& pairs);

// The events of an update. A pair in both lists ended, and another pair with the same proxy numbers began.
struct PairEvents {
    ProxyPairs began, ended;

    bool empty() const noexcept { return began.empty() && ended.empty(); }
    void clear() noexcept {
        began.clear();
        ended.clear();
    }
};

// The keeper of the pairs that began at earlier updates and have not ended since. Finders keep no pairs. If a call
// throws, the kept pairs are unchanged.
class PairKeeper {
  public:
    // Appends the kept pairs of the boxes that were removed, each once, in any order.
    virtual void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) = 0;

    // Sets the events to the differences between the kept pairs and `found`, which holds all pairs that overlap now,
    // ascending. Pairs of removed boxes have ended; if such a pair is in `found`, it has begun again. `found` is left
    // with unspecified contents, as scratch.
    virtual void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found,
                         PairEvents& events) = 0;

  protected:
    ~PairKeeper() = default;
};

}  // namespace ecods
