// Holds the pairs that the caller switched off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

class DisabledPairs {
  public:
    // Return true if this changed anything. A call that throws changes nothing.
    bool insert(ProxyPair pair);
    bool erase(ProxyPair pair) noexcept;

    // True if the pair is switched off. Searches only if both bodies have a pair here.
    bool contains(ProxyPair pair) const noexcept {
        return count_of(pair.a) != 0 && count_of(pair.b) != 0 && pairs_.contains({pair.a, pair.b});
    }

    // Removes all pairs of a body.
    void forget(ProxyIndex proxy) noexcept;

    // Returns the pairs, ascending.
    std::vector<ProxyPair> list() const;

    std::size_t memory_bytes() const noexcept;

  private:
    std::uint32_t count_of(ProxyIndex proxy) const noexcept { return proxy < counts_.size() ? counts_[proxy] : 0; }

    std::set<std::pair<ProxyIndex, ProxyIndex>> pairs_;  // each pair in both orders
    std::vector<std::uint32_t> counts_;                  // number of pairs, by proxy
};

}  // namespace ecods
