#include "world/cached_pairs.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace ecods {
namespace {

// Lists, for each proxy, its partners in cached pairs that have a larger index. So each cached pair is listed once.
class PartnerLists {
  public:
    // Fills the lists by a counting sort, which compares no pairs.
    PartnerLists(const VerdictCache& cache, ProxyIndex proxy_end)
        : ends_(std::size_t{proxy_end} + 1), partners_(cache.size()) {
        for (VerdictIndex index = 0; index < cache.size(); ++index) ++ends_[cache[index].proxies().a + 1];
        for (std::size_t proxy = 1; proxy < ends_.size(); ++proxy) ends_[proxy] += ends_[proxy - 1];
        // Before the loop below, ends_[proxy] is where the list of `proxy` begins; the loop advances it to where the
        // list ends.
        for (VerdictIndex index = 0; index < cache.size(); ++index) {
            const ProxyPair pair = cache[index].proxies();
            partners_[ends_[pair.a]++] = pair.b;
        }
    }

    // Returns the partners of `proxy` that have larger indices, in no promised order.
    std::span<const ProxyIndex> of(ProxyIndex proxy) const noexcept {
        const std::size_t begin = proxy == 0 ? 0 : ends_[proxy - 1];
        return {partners_.data() + begin, ends_[proxy] - begin};
    }

  private:
    std::vector<std::uint32_t> ends_;
    std::vector<ProxyIndex> partners_;
};

}  // namespace

void CachedPairs::append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) {
    for (const ProxyIndex proxy : changes.removed) {
        for (auto index = cache_.first(proxy); index != no_verdict; index = cache_.next(index, proxy)) {
            const ProxyPair pair = cache_[index].proxies();
            const bool is_appended_by_partner = proxy == pair.b && table.is_removed(pair.a);
            if (!is_appended_by_partner) ended.push_back(pair);
        }
    }
}

void CachedPairs::compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) {
    constexpr ProxyIndex nobody = std::numeric_limits<ProxyIndex>::max();
    events.clear();
    const PartnerLists kept(cache_, table.end());
    const bool has_removed = !changes.removed.empty();
    std::vector<ProxyIndex> kept_with(table.end(),
                                      nobody);  // by partner: smaller proxy of a cached pair not found yet
    auto pair = found.begin();
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        for (const ProxyIndex partner : kept.of(proxy)) kept_with[partner] = proxy;
        for (; pair != found.end() && pair->a == proxy; ++pair) {
            const bool is_another = has_removed && (table.is_removed(pair->a) || table.is_removed(pair->b));
            if (kept_with[pair->b] == proxy && !is_another) {
                kept_with[pair->b] = nobody;
            } else {
                events.began.push_back(*pair);
            }
        }
        for (const ProxyIndex partner : kept.of(proxy)) {
            if (kept_with[partner] == proxy) events.ended.push_back({proxy, partner});
        }
    }
    sort_pairs(events.ended);
}

}  // namespace ecods
