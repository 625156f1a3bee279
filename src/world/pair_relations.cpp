#include "world/pair_relations.hpp"

#include <algorithm>

namespace ecods {

void PairRelations::add_test(const Verdict& verdict, bool collides, const Bodies& bodies) {
    const auto [a, b] = verdict.proxies();
    const bool is_related = is_of_solids_ ? bodies[a].solid() != nullptr && bodies[b].solid() != nullptr : collides;
    if (is_related) tests_.push_back({verdict.bodies, Relation::apart});
}

// Calls add_test() for each pair that the update neither tested nor filtered out, because the last verdict of the pair
// holds.
void PairRelations::add_untouched(const Bodies& bodies, const VerdictCache& verdicts) {
    for (VerdictIndex index = 0; index < verdicts.size(); ++index) {
        const Verdict& verdict = verdicts[index];
        if (!verdict.is_enabled || std::ranges::binary_search(touched_, verdict.bodies)) continue;
        add_test(verdict, verdict.is_positive, bodies);
    }
}

void PairRelations::follow(const Bodies& bodies, const PairVerdicts& collisions) {
    tests_.clear();
    touched_.clear();
    if (!are_wanted_) return;
    for (const VerdictIndex index : collisions.tests()) {
        const Verdict& verdict = collisions.verdicts()[index];
        touched_.push_back(verdict.bodies);
        if (verdict.answer != Answer::filtered_out) add_test(verdict, verdict.answer == Answer::yes, bodies);
    }
    std::ranges::sort(touched_);
    if (!are_listed_) add_untouched(bodies, collisions.verdicts());
}

// Computes the next list of relations. A listed pair stays if this update did not process it and neither body changed.
// Any other listed pair is in tests_ again, or is filtered out, apart, or has ended.
void PairRelations::prepare(const Changes& changes) {
    next_.clear();
    if (!are_wanted_) return;
    for (const PairRelation& pair : list_) {
        if (changes.voids_verdict_of({pair.bodies.a.slot - 1, pair.bodies.b.slot - 1})) continue;
        if (!std::ranges::binary_search(touched_, pair.bodies)) next_.push_back(pair);
    }
    for (const PairRelation& pair : tests_) {
        if (pair.relation != Relation::apart) next_.push_back(pair);
    }
    std::ranges::sort(next_, {}, &PairRelation::bodies);
}

void PairRelations::commit() noexcept {
    list_.swap(next_);
    are_listed_ = are_wanted_;
}

}  // namespace ecods
