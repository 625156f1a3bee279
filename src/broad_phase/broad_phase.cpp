#include "ecods/broad_phase.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "bounds/ball_bounds.hpp"
#include "bounds/segment_bounds.hpp"
#include "broad_phase/box_index.hpp"
#include "broad_phase/brute_force.hpp"
#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "broad_phase/choose_finder.hpp"
#include "broad_phase/sweep/find_pairs.hpp"
#include "broad_phase/sweep/sweep_and_prune.hpp"
#include "broad_phase/validate_pairs.hpp"
#include "ecods/error.hpp"
#include "geometry/key_box.hpp"

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

// A box, prepared as SegmentBounds and BallBounds are.
class BoxBounds {
  public:
    explicit BoxBounds(const Aabb& box) : keys_(key_box(box)) { make_reach(packed_box(keys_), reach_); }

    const BoxReach& reach() const noexcept { return reach_; }
    bool meets(const Aabb& box) const noexcept { return overlap(keys_, key_box(box)); }

  private:
    KeyBox keys_;
    BoxReach reach_;
};

const BoxReach& for_trees(const BoxBounds& bounds) {
    return bounds.reach();
}
template <class Bounds>
const Bounds& for_trees(const Bounds& bounds) {
    return bounds;
}

// The boxes, the pairs, and something that finds them.
class FindingBroadPhase final : public BroadPhase {
  public:
    explicit FindingBroadPhase(BroadPhaseKind kind)
        : kind_(kind),
          running_(kind == BroadPhaseKind::automatic ? BroadPhaseKind::sweep_and_prune : kind),
          finder_(make_finder(running_)) {}

    BroadPhaseKind kind() const noexcept override { return kind_; }
    void reserve(std::size_t count) override {
        table_.reserve(count);
        if (finder_) finder_->reserve(count);
    }
    void add(ProxyIndex proxy, const Aabb& box) override {
        table_.add(proxy, box);
        note(proxy);
    }
    void move(ProxyIndex proxy, const Aabb& box) override {
        table_.move(proxy, box);
        note(proxy);
    }
    void remove(ProxyIndex proxy) override {
        table_.remove(proxy);
        note(proxy);
    }
    Aabb box(ProxyIndex proxy) const override { return table_.box(proxy); }
    std::size_t size() const noexcept override { return table_.size(); }

    // A failure leaves the table and the list of pairs as they were. The finder, which may have changed in part, is
    // dropped: the next update looks everything up.
    void update() override {
        const ProxyChanges& changes = table_.collect();
        pairs_.begin_update();
        const BroadPhaseCounts before = counts_;
        ++counts_.updates;
        if (changes.empty()) {
            table_.settle();  // of what came and went in between
            return;
        }
        const std::size_t moved_count = changes.moved.size();
        counts_.moved += changes.added.size() + moved_count;
        try {
            finder_ ? finder_->update(table_, changes, pairs_, counts_) : find_pairs_again(changes);
            pairs_.end_update();
        } catch (...) {
            finder_ = nullptr;
            pairs_.drop_update();
            counts_ = before;
            throw;
        }
        // Nothing below throws.
        table_.settle();
        if (kind_ == BroadPhaseKind::automatic) choose(moved_count, counts_.swaps - before.swaps);
        if (!finder_) build_finder();
    }

    const std::vector<ProxyPair>& pairs() override { return pairs_.sorted(); }
    const std::vector<ProxyPair>& began() const noexcept override { return pairs_.began; }
    const std::vector<ProxyPair>& ended() const noexcept override { return pairs_.ended; }
    std::vector<ProxyIndex> find(const Aabb& box) const override {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(box.min[axis] <= box.max[axis])) throw InvalidBox(axis, box.min[axis], box.max[axis]);
        }
        return find_all(BoxBounds(box));
    }
    std::vector<ProxyIndex> find(const Segment& segment) const override {
        ecods::validate(segment);
        return find_all(SegmentBounds(segment));
    }
    std::vector<ProxyIndex> find(const Ball& ball) const override {
        ecods::validate(ball);
        return find_all(BallBounds(ball));
    }
    FindCounts find_counts() const noexcept override {
        return {.calls = find_calls_.load(std::memory_order_relaxed),
                .box_tests = find_tests_.load(std::memory_order_relaxed),
                .refreshed = find_refreshed_.load(std::memory_order_relaxed)};
    }

    const BroadPhaseCounts& counts() const noexcept override { return counts_; }
    std::size_t bytes() const noexcept override {
        const std::lock_guard lock(index_mutex_);
        return table_.bytes() + pairs_.bytes() + (finder_ ? finder_->bytes() : 0) + (index_ ? index_->bytes() : 0);
    }

    void validate() const override {
        if (finder_) finder_->validate(table_);
        {
            const std::lock_guard lock(index_mutex_);
            if (index_) index_->validate(table_);
        }
        PairList pairs = pairs_;
        validate_pairs(table_, pairs.sorted(), pairs_.began, pairs_.ended);
    }

  private:
    // Up to here testing all boxes costs no more than trees do.
    static constexpr std::size_t scanned_max = 64;

    bool has_trees() const noexcept {
        return (kind_ == BroadPhaseKind::kept_candidates || kind_ == BroadPhaseKind::automatic) &&
               table_.size() > scanned_max;
    }

    // The index is made and brought up to date by the questions, which are const. Nothing else reads it, and what is
    // not const does not run beside them: so a question that finds it up to date needs no lock.
    void note(ProxyIndex proxy) noexcept {
        if (!index_) return;
        index_->note(proxy);
        index_is_current_.store(false, std::memory_order_relaxed);
    }
    const BoxIndex& current_index() const {
        if (index_is_current_.load(std::memory_order_acquire)) return *index_;
        const std::lock_guard lock(index_mutex_);
        if (!index_is_current_.load(std::memory_order_relaxed)) {
            if (!index_) index_ = std::make_unique<BoxIndex>();
            find_refreshed_.fetch_add(index_->refresh(table_), std::memory_order_relaxed);
            index_is_current_.store(true, std::memory_order_release);
        }
        return *index_;
    }

    template <class Bounds>
    std::vector<ProxyIndex> find_all(const Bounds& bounds) const {
        std::vector<ProxyIndex> found;
        std::uint64_t tests = 0;
        if (has_trees()) {
            tests = current_index().find(for_trees(bounds), found) + found.size();
            std::erase_if(found, [&](ProxyIndex proxy) { return !bounds.meets(table_.boxes()[proxy]); });
            std::sort(found.begin(), found.end());
        } else {
            tests = table_.size();
            for (ProxyIndex proxy = 0; proxy < table_.end(); ++proxy) {
                if (table_.is_present(proxy) && bounds.meets(table_.boxes()[proxy])) found.push_back(proxy);
            }
        }
        find_calls_.fetch_add(1, std::memory_order_relaxed);
        find_tests_.fetch_add(tests, std::memory_order_relaxed);
        return found;
    }

    // The pairs, without a finder.
    void find_pairs_again(const ProxyChanges& changes) {
        if (!changes.removed.empty()) {
            for (const ProxyPair& pair : pairs_.sorted()) {
                if (table_.is_removed(pair.a) || table_.is_removed(pair.b)) pairs_.ended.push_back(pair);
            }
        }
        std::vector<ProxyIndex> present;
        present.reserve(table_.size());
        for (ProxyIndex proxy = 0; proxy < table_.end(); ++proxy) {
            if (table_.is_present(proxy)) present.push_back(proxy);
        }
        ProxyPairs found;
        counts_.box_tests += find_pairs_of(present, table_, found);
        sort_pairs(found);
        pairs_.replace(found);
    }

    void choose(std::size_t moved, std::uint64_t swaps) noexcept {
        const BroadPhaseKind wanted = chooser_.choose({.size = table_.size(), .moved = moved, .swaps = swaps});
        if (wanted == running_) return;
        running_ = wanted;
        finder_ = nullptr;
        ++counts_.switches;
    }

    // The update is complete by now: one that finds no memory for a finder leaves it to the next update.
    void build_finder() noexcept {
        try {
            auto made = make_finder(running_);
            made->build(table_, counts_);
            finder_ = std::move(made);
        } catch (const std::bad_alloc&) {
        }
    }

    BroadPhaseKind kind_;
    BroadPhaseKind running_;  // another than kind_ when that is automatic
    ChooseFinder chooser_;
    ProxyTable table_;
    PairList pairs_;
    std::unique_ptr<PairFinder> finder_;  // null after a failure
    BroadPhaseCounts counts_;

    mutable std::mutex index_mutex_;
    mutable std::unique_ptr<BoxIndex> index_;
    mutable std::atomic<bool> index_is_current_ = false;
    mutable std::atomic<std::uint64_t> find_calls_ = 0, find_tests_ = 0, find_refreshed_ = 0;
};

}  // namespace

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind) {
    return std::make_unique<FindingBroadPhase>(kind);
}

}  // namespace ecods
