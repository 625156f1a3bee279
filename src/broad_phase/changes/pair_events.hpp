// Defines the events of an update, which are the pairs that began and the pairs that ended, and the interface of the
// keeper of the pairs.
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

// Returns a number that is ordered as pairs are: rank_of(a) < rank_of(b) exactly if a < b.
constexpr std::uint64_t rank_of(const ProxyPair& pair) noexcept {
    return std::uint64_t{pair.a} << 32 | pair.b;
}

// Compares pairs by their ranks. The comparison is a function object so that algorithms inline it.
inline constexpr auto is_before = [](const ProxyPair& a, const ProxyPair& b) { return rank_of(a) < rank_of(b); };

// Sorts the pairs, ascending.
void sort_pairs(ProxyPairs& pairs);

// Sorts the pairs, ascending, and removes duplicates.
void normalise(ProxyPairs& pairs);

// Holds the events of an update. A pair in both lists ended because one of its boxes was removed, and began again with
// a new box of the same proxy number.
struct PairEvents {
    ProxyPairs began, ended;

    bool empty() const noexcept { return began.empty() && ended.empty(); }
    void clear() noexcept {
        began.clear();
        ended.clear();
    }
};

// Keeps the pairs that began at earlier updates and have not ended since; finders keep no pairs. If a function throws,
// the kept pairs are unchanged.
class PairKeeper {
  public:
    // Appends to `ended` the kept pairs with at least one removed box, each once, in any order.
    virtual void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) = 0;

    // Sets `events` to the differences between the kept pairs and `found`, which holds all pairs that overlap now,
    // ascending. A kept pair with a removed box has ended; if the pair is in `found`, it has also begun again. Leaves
    // `found` with unspecified contents, since it serves as scratch.
    virtual void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found,
                         PairEvents& events) = 0;

  protected:
    ~PairKeeper() = default;
};

}  // namespace ecods
