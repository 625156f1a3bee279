// The verdicts of the candidate pairs, kept while neither body changes.
//
// The report's collision cache: a pair that did not move is not tested again. A pair is here exactly while its boxes
// overlap. Each body knows its partners, so that a body that moved finds its pairs at their cost.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/ids.hpp"

namespace ecods {

struct Verdict {
    BodyPair bodies;  // with the generations that the pair began with
    bool colliding;   // false until the pair is tested
};

class VerdictCache {
  public:
    void add(ProxyPair pair, const BodyPair& bodies);
    Verdict remove(ProxyPair pair);  // must be here

    Verdict& at(ProxyPair pair) { return verdicts_.at(key(pair)); }
    const Verdict* find(ProxyPair pair) const;
    std::size_t size() const noexcept { return verdicts_.size(); }

    // The bodies whose boxes overlap that of `proxy`, in no order.
    const std::vector<ProxyIndex>& partners(ProxyIndex proxy) const;

  private:
    static std::uint64_t key(ProxyPair pair) noexcept { return std::uint64_t{pair.a} << 32 | pair.b; }
    void forget_partner(ProxyIndex proxy, ProxyIndex partner);

    struct KeyHash {
        std::size_t operator()(std::uint64_t key) const noexcept;
    };
    std::unordered_map<std::uint64_t, Verdict, KeyHash> verdicts_;
    std::vector<std::vector<ProxyIndex>> partners_;
};

}  // namespace ecods
