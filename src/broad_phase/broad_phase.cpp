#include "ecods/broad_phase.hpp"

#include "broad_phase/brute_force.hpp"
#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/changes/pair_list.hpp"
#include "broad_phase/changes/proxy_table.hpp"
#include "broad_phase/choose_finder.hpp"
#include "broad_phase/pair_finder.hpp"
#include "broad_phase/sweep/sweep_and_prune.hpp"
#include "broad_phase/validate_pairs.hpp"

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

// The boxes, the pairs, and something that finds them.
class FindingBroadPhase final : public BroadPhase {
  public:
    explicit FindingBroadPhase(BroadPhaseKind kind) : kind_(kind), finder_(make_finder(kind)) {}

    BroadPhaseKind kind() const noexcept override { return kind_; }
    void reserve(std::size_t count) override {
        table_.reserve(count);
        finder_->reserve(count);
    }
    void add(ProxyIndex proxy, const Aabb& box) override { table_.add(proxy, box); }
    void move(ProxyIndex proxy, const Aabb& box) override { table_.move(proxy, box); }
    void remove(ProxyIndex proxy) override { table_.remove(proxy); }
    Aabb box(ProxyIndex proxy) const override { return table_.box(proxy); }
    std::size_t size() const noexcept override { return table_.size(); }

    void update() override {
        ++counts_.updates;
        pairs_.begin_update();
        const ProxyChanges& changes = table_.collect();
        if (changes.empty()) {
            table_.settle();  // of what came and went in between
            return;
        }
        const std::uint64_t swaps_before = counts_.swaps;
        const std::size_t moved_count = changes.moved.size();
        counts_.moved += changes.added.size() + moved_count;
        finder_->update(table_, changes, pairs_, counts_);
        pairs_.end_update();
        table_.settle();
        if (kind_ == BroadPhaseKind::automatic) choose(moved_count, counts_.swaps - swaps_before);
    }

    const std::vector<ProxyPair>& pairs() override { return pairs_.sorted(); }
    const std::vector<ProxyPair>& began() const noexcept override { return pairs_.began; }
    const std::vector<ProxyPair>& ended() const noexcept override { return pairs_.ended; }
    const BroadPhaseCounts& counts() const noexcept override { return counts_; }
    std::size_t bytes() const noexcept override { return table_.bytes() + pairs_.bytes() + finder_->bytes(); }

    void validate() const override {
        finder_->validate(table_);
        PairList pairs = pairs_;
        validate_pairs(table_, pairs.sorted(), pairs_.began, pairs_.ended);
    }

  private:
    void choose(std::size_t moved, std::uint64_t swaps) {
        const BroadPhaseKind wanted = chooser_.choose({.size = table_.size(), .moved = moved, .swaps = swaps});
        if (wanted == running_) return;
        running_ = wanted;
        finder_ = make_finder(wanted);
        finder_->build(table_, counts_);
        ++counts_.switches;
    }

    BroadPhaseKind kind_;
    BroadPhaseKind running_ = BroadPhaseKind::sweep_and_prune;  // when automatic
    ChooseFinder chooser_;
    ProxyTable table_;
    PairList pairs_;
    std::unique_ptr<PairFinder> finder_;
    BroadPhaseCounts counts_;
};

}  // namespace

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind) {
    return std::make_unique<FindingBroadPhase>(kind);
}

}  // namespace ecods
