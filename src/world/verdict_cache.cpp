#include "world/verdict_cache.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace ecods {

std::size_t VerdictCache::KeyHash::operator()(std::uint64_t key) const noexcept {
    return mix(key);
}

void VerdictCache::add(ProxyPair pair, const BodyPair& bodies) {
    if (partners_.size() <= pair.b) partners_.resize(std::size_t{pair.b} + 1);
    verdicts_.emplace(key(pair), Verdict{bodies, false});
    partners_[pair.a].push_back(pair.b);
    partners_[pair.b].push_back(pair.a);
}

Verdict VerdictCache::remove(ProxyPair pair) {
    const auto found = verdicts_.find(key(pair));
    const Verdict verdict = found->second;
    verdicts_.erase(found);
    forget_partner(pair.a, pair.b);
    forget_partner(pair.b, pair.a);
    return verdict;
}

const Verdict* VerdictCache::find(ProxyPair pair) const {
    const auto found = verdicts_.find(key(pair));
    return found == verdicts_.end() ? nullptr : &found->second;
}

const std::vector<ProxyIndex>& VerdictCache::partners(ProxyIndex proxy) const {
    static const std::vector<ProxyIndex> none;
    return proxy < partners_.size() ? partners_[proxy] : none;
}

void VerdictCache::forget_partner(ProxyIndex proxy, ProxyIndex partner) {
    std::vector<ProxyIndex>& list = partners_[proxy];
    const auto found = std::ranges::find(list, partner);
    *found = list.back();
    list.pop_back();
}

}  // namespace ecods
