// The broad phase for large, dynamic scenes: pairs that may overlap for a while, kept and filtered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/candidates/candidate_list.hpp"
#include "broad_phase/candidates/fat_forest.hpp"
#include "broad_phase/candidates/keeping_rule.hpp"
#include "broad_phase/candidates/look_ups.hpp"
#include "broad_phase/candidates/margins.hpp"
#include "broad_phase/candidates/rebuild_rule.hpp"
#include "broad_phase/candidates/slot_table.hpp"
#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/scratch/grid_sweep.hpp"
#include "broad_phase/scratch/list_pairs.hpp"

namespace ecods {

// Each box lies in a fat one, with a margin in which it can go on as it does (margins.hpp). As long as boxes stay in
// their fat boxes, only those can overlap whose fat boxes do. A box that moves is awake, and so it stays until it has
// been at rest for a while (slot_table.hpp). Pairs whose fat boxes overlap, one of the two awake, are the candidates;
// an update tests all of them in one go, and nothing else (candidate_list.hpp). A box that escaped gets a new fat box
// and looks for new candidates in trees of fat boxes, as one that awakes does in its old fat box (fat_forest.hpp); when
// many did (rebuild_rule.hpp), everything is searched for at once, by a sweep from scratch, and compared with the pairs
// there were. Where that would be so time after time, boxes have no margins, none is awake, and each update searches
// for the pairs themselves (keeping_rule.hpp).
//
// Right whatever the fat boxes are, as long as they contain their boxes; how fat they are is a matter of speed.
class KeptCandidates final : public PairFinder {
  public:
    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const FindingUpdate& finding) override;
    void reserve(std::size_t count) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable& table) const override;

  private:
    // What an update that looks up few boxes hands from step to step.
    struct Update {
        const FindingUpdate& finding;
        bool are_removed_reported;     // the pairs of boxes that were removed are among the events
        std::uint64_t jump_tests = 0;  // for boxes that are far from where they were
    };
    // Boxes that were given other fat boxes, in an update.
    struct Fattened {
        std::size_t count = 0, came = 0;
        std::vector<SlotIndex> far;  // from where they were
    };
    struct Foresight {
        KeepingRule::Forecast forecast;
        Vec3 common_step;
        double lifetime_of_fast;  // updates for which the widest margins last
    };

    // kept_candidates.cpp
    bool look_up_changes(const FindingUpdate& finding, std::size_t woken);
    void remove(Update& update);
    bool move(const FindingUpdate& finding, bool fattens);
    void adapt_margins(const ProxyTable& table);
    bool do_most_move(const ProxyChanges& changes) const noexcept;
    void test_candidates(const Update& update);
    void add(ProxyIndex proxy, const ProxyTable& table);
    void put_to_sleep(std::size_t moved_count);
    void release_working_memory();

    // kept_candidates_wake.cpp
    void wake(const FindingUpdate& finding);
    void widen_woken(const ProxyTable& table);
    void link_woken(std::size_t begin, std::size_t end, BroadPhaseCounts& counts);

    // kept_candidates_search.cpp
    PackedBox fatten(std::size_t index, const ProxyTable& table);
    void search_escaped(Update& update);
    void link(std::size_t begin, std::size_t end, Update& update);
    void link(SlotIndex slot, const PackedBox& old_fat, const LookUps::NewPartner& found, const Update& update);
    const PackedBox& fat_line_before(SlotIndex slot) const noexcept;

    // kept_candidates_foresight.cpp
    Foresight foresee(const ProxyTable& table, const ProxyChanges& changes) const;
    double lifetime_of_escaped(const ProxyTable& table) const;

    // kept_candidates_everything.cpp
    void replace_everything(const FindingUpdate& finding);
    void search_everything(const ProxyTable& table, bool must_sort, BroadPhaseCounts& counts);
    void fatten_everything(const ProxyTable& table, bool must_sort);
    void sort_slots(const ProxyTable& table);
    void fatten_escaped(const ProxyTable& table);
    void drop_candidates();

    SlotTable slots_;
    Margins margins_;
    CandidateList candidates_;
    FatForest forest_;
    GridSweep search_;
    KeepingRule keeping_;
    RebuildRule rebuild_;
    bool has_margins_ = true;  // otherwise fat boxes are of any time, and there are no candidates

    // Working memory of an update.
    std::vector<EscapedBox> escaped_;
    std::vector<SlotIndex> looked_up_;  // those that awake, and then those that escaped
    std::vector<PackedBox> old_fats_;   // of those that are looked up: their fat boxes before; empty of one that came
    Fattened fattened_;
    LookUps look_ups_;
    std::vector<SlotIndex> found_;
    ProxyPairs pairs_;  // that a search for everything found
    ListingMemory listing_;
};

}  // namespace ecods
