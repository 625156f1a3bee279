// The pairs that came and went with an update, and what finders of pairs ask of whoever keeps them.
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

// One number that orders as the pair does.
constexpr std::uint64_t rank_of(const ProxyPair& pair) noexcept {
    return std::uint64_t{pair.a} << 32 | pair.b;
}

// Orders pairs by their ranks; an object, so that algorithms do not call it through a pointer.
inline constexpr auto is_before = [](const ProxyPair& a, const ProxyPair& b) { return rank_of(a) < rank_of(b); };

// Sorts ascending.
void sort_pairs(ProxyPairs& pairs);

// Sorts, and leaves each pair once.
void normalise(ProxyPairs& pairs);

// A pair may be in both: then it ended, and another of the same numbers began.
struct PairEvents {
    ProxyPairs began, ended;

    bool empty() const noexcept { return began.empty() && ended.empty(); }
    void clear() noexcept {
        began.clear();
        ended.clear();
    }
};

// Whoever keeps the pairs: those that began at earlier updates and have not ended since. The finders keep none. Where a
// call throws, what is kept is as it was.
class PairKeeper {
  public:
    // Appends the pairs kept of the boxes that were removed, each once, in any order.
    virtual void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) = 0;

    // Makes the events the differences between the pairs kept and `found`, which are all pairs of now, ascending. Pairs
    // of boxes that were removed have ended, and those of them that were found have begun again. What is left in
    // `found` is memory to be used again.
    virtual void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found,
                         PairEvents& events) = 0;

  protected:
    ~PairKeeper() = default;
};

}  // namespace ecods
