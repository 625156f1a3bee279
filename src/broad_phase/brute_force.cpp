#include "broad_phase/brute_force.hpp"

#include "broad_phase/validate_pairs.hpp"

namespace ecods {

void BruteForce::update() {
    ++counts_.updates;
    began_.clear();
    ended_.clear();
    const ProxyChanges& changes = table_.collect();
    counts_.moved += changes.added.size() + changes.moved.size();
    if (!changes.empty()) {
        if (!changes.removed.empty()) end_removed(pairs_, table_, ended_);
        counts_.box_tests += all_pairs(table_, found_);
        replace_pairs(found_, pairs_, began_, ended_);
    }
    table_.settle();
}

void BruteForce::validate() const {
    validate_pairs(table_, pairs_, began_, ended_);
}

}  // namespace ecods
