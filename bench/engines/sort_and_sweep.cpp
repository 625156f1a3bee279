#include "engines/sort_and_sweep.hpp"

namespace ecods::bench {

void SortAndSweep::update() {
    pairs_.begin_update();
    events_.clear();
    const ProxyChanges& changes = table_.collect();
    if (!changes.empty()) find(changes);
    table_.settle();
    pairs_.end_update();
}

void SortAndSweep::find(const ProxyChanges& changes) {
    lines_.resize(table_.end());
    for (const ProxyIndex proxy : changes.removed) lines_[proxy] = {};
    for (const ProxyIndex proxy : changes.moved) make_packed_box(table_.boxes()[proxy], lines_[proxy]);
    for (const ProxyIndex proxy : changes.added) make_packed_box(table_.boxes()[proxy], lines_[proxy]);
    found_.clear();
    search_.find_pairs(lines_, found_);
    list_pairs(found_, lines_.size(), ascending_, listing_);
    pairs_.compare(table_, changes, ascending_, events_);
}

}  // namespace ecods::bench
