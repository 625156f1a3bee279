// Defines the broad phase for large, dynamic scenes: it keeps pairs that may overlap over several updates, and filters
// them.
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

// Keeps the pairs of boxes that may overlap during the next updates, and tests only these pairs. Each box lies in a fat
// box, with a margin within which it can go on moving as it does (margins.hpp). As long as boxes stay in their fat
// boxes, two boxes can overlap only if their fat boxes do. A box that moves is awake, and stays awake until it has been
// at rest for a while (slot_table.hpp). The candidates are the pairs whose fat boxes overlap, with at least one box
// awake. An update tests all candidates in one pass, and no other pairs (candidate_list.hpp). A box that escaped from
// its fat box gets a new fat box, and looks for new candidates in trees of fat boxes; a box that wakes up looks for
// candidates with its old fat box (fat_forest.hpp). If many boxes escaped (rebuild_rule.hpp), a full search finds the
// pairs of all boxes at once, by a sweep from scratch, and the result is compared with the previous pairs. If most
// updates would need a full search, boxes have no margins, no box is awake, and each update searches for the
// overlapping pairs from scratch (keeping_rule.hpp).
//
// The pairs are right for any fat boxes that contain their boxes; the size of the margins affects only the speed.
class KeptCandidates final : public PairFinder {
  public:
    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const FindingUpdate& finding) override;
    void reserve(std::size_t count) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable& table) const override;

  private:
    // Holds the data that the steps of an update pass to each other, if the update looks up few boxes.
    struct Update {
        const FindingUpdate& finding;
        bool are_removed_reported;     // true if the events include the pairs of removed boxes already
        std::uint64_t jump_tests = 0;  // tests for boxes that are far from where they were
    };
    // Counts the boxes that got new fat boxes in an update, and among these the boxes that were added.
    struct Fattened {
        std::size_t count = 0, came = 0;
        std::vector<SlotIndex> far;  // slots of boxes that are new, or far from where they were
    };
    struct Foresight {
        KeepingRule::Forecast forecast;
        Vec3 common_step;
        double lifetime_of_fast;  // number of updates that the widest margin of a fast box lasts
    };

    // These functions are in kept_candidates.cpp.
    bool look_up_changes(const FindingUpdate& finding, std::size_t woken);
    void remove(Update& update);
    bool move(const FindingUpdate& finding, bool fattens);
    void adapt_margins(const ProxyTable& table);
    bool do_most_move(const ProxyChanges& changes) const noexcept;
    void test_candidates(const Update& update);
    void add(ProxyIndex proxy, const ProxyTable& table);
    void put_to_sleep(std::size_t moved_count);
    void release_working_memory();

    // These functions are in kept_candidates_wake.cpp.
    void wake(const FindingUpdate& finding);
    void widen_woken(const ProxyTable& table);
    void link_woken(std::size_t begin, std::size_t end, BroadPhaseCounts& counts);

    // These functions are in kept_candidates_search.cpp.
    PackedBox fatten(std::size_t index, const ProxyTable& table);
    void search_escaped(Update& update);
    void link(std::size_t begin, std::size_t end, Update& update);
    void link(SlotIndex slot, const PackedBox& old_fat, const LookUps::NewPartner& found, const Update& update);
    const PackedBox& fat_line_before(SlotIndex slot) const noexcept;

    // These functions are in kept_candidates_foresight.cpp.
    Foresight foresee(const ProxyTable& table, const ProxyChanges& changes) const;
    double lifetime_of_escaped(const ProxyTable& table) const;

    // These functions are in kept_candidates_everything.cpp.
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
    bool has_margins_ = true;  // if false, fat boxes are stale, and there are no candidates

    // The members below are scratch of an update.
    std::vector<EscapedBox> escaped_;
    std::vector<SlotIndex> looked_up_;  // slots of boxes that wake up; later in the update, slots of boxes that escaped
    std::vector<PackedBox> old_fats_;   // previous fat boxes of looked_up_; an added box has an empty one
    Fattened fattened_;
    LookUps look_ups_;
    std::vector<SlotIndex> found_;
    ProxyPairs pairs_;  // pairs that a full search found
    ListingMemory listing_;
};

}  // namespace ecods
