#include "broad_phase/overlap_tracker.hpp"

#include <new>
#include <utility>

#include "base/bytes_of.hpp"
#include "broad_phase/brute_force.hpp"
#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/choose_finder.hpp"
#include "broad_phase/sweep/find_pairs.hpp"
#include "broad_phase/sweep/sweep_and_prune.hpp"

namespace ecods {
namespace {

std::unique_ptr<PairFinder> make_finder(BroadPhaseKind kind) {
    switch (kind) {
        case BroadPhaseKind::brute_force:
            return std::make_unique<BruteForce>();
        case BroadPhaseKind::kept_candidates:
            return std::make_unique<KeptCandidates>();
        case BroadPhaseKind::sweep_and_prune:
        case BroadPhaseKind::automatic:
            break;
    }
    return std::make_unique<SweepAndPrune>();
}

}  // namespace

OverlapTracker::OverlapTracker(BroadPhaseKind kind)
    : kind_(kind),
      running_(kind == BroadPhaseKind::automatic ? BroadPhaseKind::sweep_and_prune : kind),
      finder_(make_finder(running_)) {}

void OverlapTracker::reserve(std::size_t count) {
    table_.reserve(count);
    if (finder_) finder_->reserve(count);
}

// Sets events_ to the pairs that began and ended since the last update. If the update fails, the table stays as it was;
// the finder, which may have changed in part, is dropped, and the next update finds all pairs from scratch.
void OverlapTracker::update(PairKeeper& keeper) {
    events_.clear();
    const ProxyChanges& changes = table_.collect();
    const BroadPhaseCounts before = counts_;
    ++counts_.updates;
    if (changes.empty()) {
        table_.settle();  // forgets boxes that were added and removed since the last update
        return;
    }
    counts_.moved += changes.added.size() + changes.moved.size();
    try {
        if (changes.added.size() == table_.size() && changes.removed.empty()) begin();
        const FindingUpdate update{
            .table = table_, .changes = changes, .keeper = keeper, .events = events_, .counts = counts_};
        finder_ ? finder_->update(update) : update_from_scratch(update);
    } catch (...) {
        finder_ = nullptr;
        events_.clear();
        counts_ = before;
        throw;
    }
    // Nothing below throws.
    table_.settle();
    if (kind_ == BroadPhaseKind::automatic) choose();
    if (!finder_) build_finder();
}

// Chooses and makes the finder before an update in which all boxes are new, so that the finder that suits these boxes
// performs this update already.
void OverlapTracker::begin() {
    if (kind_ == BroadPhaseKind::automatic) choose();
    if (!finder_) finder_ = make_finder(running_);
}

void OverlapTracker::choose() noexcept {
    const BroadPhaseKind wanted = choose_finder(running_, table_.size());
    if (wanted == running_) return;
    running_ = wanted;
    finder_ = nullptr;
    ++counts_.switches;
}

// Builds the finder from the boxes after an update. If memory runs out, finder_ stays null, and the next update tries
// again.
void OverlapTracker::build_finder() noexcept {
    try {
        auto made = make_finder(running_);
        made->build(table_, counts_);
        finder_ = std::move(made);
    } catch (const std::bad_alloc&) {
    }
}

std::size_t OverlapTracker::bytes() const noexcept {
    const std::lock_guard lock(index_mutex_);
    return table_.bytes() + bytes_of(events_.began, events_.ended) + (finder_ ? finder_->bytes() : 0) +
           (index_ ? index_->bytes() : 0);
}

void OverlapTracker::validate() const {
    if (finder_) finder_->validate(table_);
    const std::lock_guard lock(index_mutex_);
    if (index_) index_->validate(table_);
}

}  // namespace ecods
