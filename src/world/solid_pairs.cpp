#include "world/solid_pairs.hpp"

#include <algorithm>

namespace ecods {

void SolidPairs::follow(const Bodies& bodies, const PairVerdicts& collisions) {
    tests_.clear();
    touched_.clear();
    if (!are_wanted_) return;
    const VerdictCache& verdicts = collisions.verdicts();
    const auto add = [&](VerdictIndex index) {
        const ProxyPair pair = verdicts[index].proxies();
        if (bodies[pair.a].solid() == nullptr || bodies[pair.b].solid() == nullptr) return;
        tests_.push_back({verdicts[index].bodies, Relation::apart});
    };
    if (!are_listed_) {
        for (VerdictIndex index = 0; index < verdicts.size(); ++index) {
            if (bodies.is_enabled(verdicts[index].proxies())) add(index);
        }
        return;
    }
    for (const VerdictIndex index : collisions.tests()) {
        touched_.push_back(verdicts[index].bodies);
        if (verdicts[index].answer != Answer::filtered_out) add(index);
    }
    std::ranges::sort(touched_);
}

// Computes the next list. A listed pair stays if neither body changed and it is not in touched_; any other listed pair
// is in tests_, or filtered out, or has ended.
void SolidPairs::prepare(const Changes& changes) {
    next_.clear();
    if (!are_wanted_) return;
    for (const SolidPair& pair : list_) {
        if (changes.voids_verdict_of({pair.bodies.a.slot - 1, pair.bodies.b.slot - 1})) continue;
        if (!std::ranges::binary_search(touched_, pair.bodies)) next_.push_back(pair);
    }
    for (const SolidPair& pair : tests_) {
        if (pair.relation != Relation::apart) next_.push_back(pair);
    }
    std::ranges::sort(next_, {}, &SolidPair::bodies);
}

void SolidPairs::commit() noexcept {
    list_.swap(next_);
    are_listed_ = are_wanted_;
}

}  // namespace ecods
