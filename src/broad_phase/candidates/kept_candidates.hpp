// The broad phase for large, dynamic scenes: pairs that may overlap for a while, kept and filtered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/candidates/keeping_rule.hpp"
#include "broad_phase/candidates/moving_frame.hpp"
#include "broad_phase/changes/pair_finder.hpp"
#include "broad_phase/scratch/grid_sweep.hpp"

namespace ecods {

// Each box lies in a fat one, with a margin in which it can go on as it does. As long as boxes stay in their fat boxes,
// only those can overlap whose fat boxes do. A box that moves is awake, and so it stays until it has been at rest for a
// while. Pairs whose fat boxes overlap, one of the two awake, are the candidates; an update tests all of them in one
// go, and nothing else. A box that escaped gets a new fat box and looks for new candidates in trees of fat boxes, as
// one that awakes does in its old fat box; when many did, all candidates are searched for at once, by a sweep from
// scratch. Where that would be so time after time, boxes have no margins, none is awake, and each update searches for
// the pairs themselves (keeping_rule.hpp). Boxes are kept in slots, numbered so that neighbours are close in memory.
//
// Right whatever the fat boxes are, as long as they contain their boxes; how fat they are is a matter of speed.
class KeptCandidates final : public PairFinder {
  public:
    // How a box moved when it last escaped, by axis, and when that was.
    struct MotionHint {
        std::array<std::int8_t, 3> direction{};  // 1 up, -1 down, 0 not known
        std::array<bool, 3> turns{};
        std::uint32_t escaped_at = 0;  // the number of the update
    };

    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const FindingUpdate& finding) override;
    void reserve(std::size_t count) override;
    std::size_t bytes() const noexcept override;
    void validate(const ProxyTable& table) const override;

  private:
    // What an update hands from step to step.
    struct Update {
        const ProxyTable& table;
        ProxyPairs& began;
        ProxyPairs& ended;
        BroadPhaseCounts& counts;
        bool are_removed_reported = false;  // the pairs of boxes that were removed are in `ended`
    };
    struct Foresight {
        KeepingRule::Forecast forecast;
        Vec3 common_step;
    };
    struct Escaped {
        SlotIndex slot;
        PackedBox before;
    };
    enum : std::uint8_t {
        awake = 1,
        moved = 2,     // since boxes were last put to sleep
        changed = 4,   // its fat box did, or it went: some of its candidates may be none any more
        searching = 8  // during an update: its old fat box is in old_fat_lines_
    };
    // Two slots; in the second one, this bit says that they overlapped when they were last tested.
    using Candidate = std::array<SlotIndex, 2>;
    static constexpr SlotIndex overlap_bit = SlotIndex{1} << 31;

    struct Loops;  // kept_candidates_loops.hpp: what is compiled for each instruction set

    // kept_candidates.cpp
    void remove(const std::vector<ProxyIndex>& proxies, Update& update);
    void add(const std::vector<ProxyIndex>& proxies, const ProxyTable& table);
    SlotIndex take_slot();
    void adapt();
    void guess_lookahead(std::size_t pair_count);
    void put_to_sleep(std::size_t moved_count);

    // kept_candidates_everything.cpp
    Foresight foresee(const ProxyTable& table, const ProxyChanges& changes) const;
    void find_everything(const FindingUpdate& finding);
    void drop(ProxyIndex proxy);
    std::vector<BoxForest::Item> give_margins(const FindingUpdate& finding);
    void take_as_they_are(const ProxyTable& table, const ProxyChanges& changes);
    void mark_overlapping();

    // kept_candidates_filter.cpp
    void move_all(const ProxyTable& table);
    void move_some(std::span<const ProxyIndex> proxies, const ProxyTable& table);
    void filter(Update& update);
    void report(Candidate& candidate, Update& update);
    void report_removed(const Candidate& candidate, Update& update);

    // kept_candidates_margin.cpp
    PackedBox line_in_frame(SlotIndex slot, const Aabb& box) const noexcept;
    PackedBox fatten(const Escaped& escaped, const Aabb& box) noexcept;
    std::vector<BoxForest::Item> fatten_escaped(const ProxyTable& table);
    void prefetch(SlotIndex slot) const noexcept;
    void learn_turns();
    void fatten_used_up(const ProxyTable& table);

    // kept_candidates_search.cpp
    void wake(std::span<const ProxyIndex> proxies, Update& update);
    std::size_t count_asleep(std::span<const ProxyIndex> proxies) const noexcept;
    bool search_where_escaped(const ProxyTable& table, Update& update);
    void search_escaped(std::span<const BoxForest::Item> unsorted, Update& update);
    void link(SlotIndex slot, Update& update);
    void order_slots(std::span<const BoxForest::Item> unsorted, const ProxyTable& table, bool must_sort = false);
    void search_all(std::span<const BoxForest::Item> unsorted, bool must_sort, Update& update);
    void sort_slots(const ProxyTable& table);
    void refresh_forest(const ProxyTable& table);
    bool were_candidates(SlotIndex a, SlotIndex b) const noexcept;
    bool has_flag(SlotIndex slot, unsigned flag) const noexcept { return (flags_[slot] & flag) != 0; }
    void set_flag(SlotIndex slot, unsigned flag) noexcept { flags_[slot] |= static_cast<std::uint8_t>(flag); }
    void clear_flag(SlotIndex slot, unsigned flag) noexcept { flags_[slot] &= static_cast<std::uint8_t>(~flag); }

    // By slot. A free slot has empty boxes. Fat boxes are in a frame of their own.
    std::vector<PackedBox> lines_;
    std::vector<PackedBox> fat_lines_;
    std::vector<PackedBox> old_fat_lines_;
    std::vector<ProxyIndex> proxies_;
    std::vector<std::uint8_t> flags_;
    std::vector<MotionHint> motion_hints_;

    std::vector<Candidate> candidates_;
    std::vector<SlotIndex> slots_;  // by proxy
    std::vector<SlotIndex> free_slots_;
    std::vector<SlotIndex> changed_slots_;  // those with the flag
    MovingFrame frame_;
    GridSweep search_;
    KeepingRule rule_;
    bool has_margins_ = true;  // otherwise fat_lines_ are of any time, and there are no candidates
    ProxyPairs pairs_;         // working memory: those of an update that searched for everything

    // Of fat boxes, for looking up few. A search for everything leaves it behind; what follows is about that time.
    BoxForest forest_;
    bool is_forest_behind_ = true;
    bool is_forest_renumbered_ = true;     // slots have other numbers in it
    std::vector<SlotIndex> forest_lacks_;  // slots that are to be put into it, some of them twice or free by now

    std::size_t used_count_ = 0;  // slots that are not free
    std::size_t awake_count_ = 0;
    std::uint64_t updates_at_rest_ = 0;  // updates in which an awake box did not move, summed
    double mean_extent_ = 0;
    double lookahead_ = 24;  // the updates for which a margin is meant to last
    double wasted_work_ = 0;
    double search_work_ = 0;
    std::uint64_t jump_tests_ = 0;   // of an update, for boxes that are far from where they were
    std::uint64_t overlapping_ = 0;  // candidates that did so before the last filtering
    std::size_t searched_since_sort_ = 0;
    std::size_t escaped_since_sort_ = 0;
    std::uint32_t update_number_ = 0;
    std::size_t updates_since_search_ = 0;  // of everything
    std::array<std::uint64_t, 3> turn_counts_{};
    std::array<bool, 3> is_turning_common_{};

    // Working memory of an update.
    std::vector<Escaped> escaped_;
    std::vector<SlotIndex> found_;
};

}  // namespace ecods
