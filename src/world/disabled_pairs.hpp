// Stores the pairs of bodies that the caller switched off.
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
    // Insert or erase a pair, and return true if the set changed. A call that throws changes nothing.
    bool insert(ProxyPair pair);
    bool erase(ProxyPair pair) noexcept;

    // Returns true if the pair is switched off. The set is searched only if each of the two bodies is in a pair that is
    // switched off.
    bool contains(ProxyPair pair) const noexcept {
        return count_of(pair.a) != 0 && count_of(pair.b) != 0 && pairs_.contains({pair.a, pair.b});
    }

    // Removes all pairs of this body.
    void forget(ProxyIndex proxy) noexcept;

    // Returns the pairs, ascending.
    std::vector<ProxyPair> list() const;

    std::size_t memory_bytes() const noexcept;

  private:
    std::uint32_t count_of(ProxyIndex proxy) const noexcept { return proxy < counts_.size() ? counts_[proxy] : 0; }

    std::set<std::pair<ProxyIndex, ProxyIndex>> pairs_;  // each pair twice: as (a, b) and as (b, a)
    std::vector<std::uint32_t> counts_;                  // by proxy: number of its pairs
};

}  // namespace ecods
