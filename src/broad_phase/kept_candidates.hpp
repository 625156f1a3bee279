// The broad phase for large and lively scenes: pairs that may overlap for a while, kept and filtered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/box_forest.hpp"
#include "broad_phase/candidate_lists.hpp"
#include "broad_phase/pair_finder.hpp"

namespace ecods {

// Each box lies in a fat one, which leaves room for it to go on as it does. Two boxes whose fat boxes overlap are a
// candidate. As long as boxes stay in their fat boxes, no others can overlap, and an update tests the candidates of
// the boxes that moved, nothing else. A box that escaped gets a new fat box and looks for its candidates in trees of
// fat boxes; when many did, all is done anew at once. Boxes are kept in slots, numbered so that neighbours are close in
// memory.
//
// Right whatever the fat boxes are, as long as they contain their boxes; how fat they are is a matter of speed.
class KeptCandidates final : public PairFinder {
  public:
    void build(const ProxyTable& table, BroadPhaseCounts& counts) override;
    void update(const ProxyTable& table, const ProxyChanges& changes, PairList& pairs,
                BroadPhaseCounts& counts) override;
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
    };
    struct Escaped {
        SlotIndex slot;
        BoxLine before;
    };
    enum : std::uint8_t { is_mover = 1 };

    // kept_candidates.cpp
    void remove(const std::vector<ProxyIndex>& proxies, Update& update);
    void add(const std::vector<ProxyIndex>& proxies, const ProxyTable& table);
    SlotIndex take_slot();
    void adapt(std::uint64_t filtered, std::uint64_t searched, std::int64_t overlaps_gained);

    // filter_candidates.cpp
    void move_all(const ProxyTable& table);
    void move_some(const std::vector<ProxyIndex>& proxies, const ProxyTable& table);
    void filter_all(Update& update);
    void filter_movers(Update& update);
    void report(SlotIndex slot, std::uint32_t index, Update& update);

    // find_candidates.cpp
    BoxLine fatten(const Escaped& escaped, const Aabb& box) const noexcept;
    std::vector<TreeItem> fatten_escaped(const ProxyTable& table);
    void search_escaped(std::span<const TreeItem> newcomers, Update& update);
    void link(SlotIndex slot, Update& update);
    void search_all(std::span<const TreeItem> newcomers, bool must_sort, Update& update);
    void sort_slots(const ProxyTable& table);
    void relink_all(Update& update);
    void next_mark();
    void mark_overlapping(const CandidateLists& lists, SlotIndex slot);
    bool is_marked(SlotIndex slot) const noexcept { return marks_[slot] == mark_; }

    // By slot. A free slot has empty boxes.
    std::vector<BoxLine> lines_;
    std::vector<BoxLine> fat_lines_;
    std::vector<ProxyIndex> proxies_;
    std::vector<std::uint8_t> flags_;
    std::vector<std::uint32_t> marks_;
    CandidateLists candidates_;

    std::vector<SlotIndex> slots_;  // by proxy
    std::vector<SlotIndex> free_slots_;
    BoxForest forest_;  // of fat boxes

    std::uint32_t mark_ = 0;
    double mean_extent_ = 0;
    double horizon_ = 24;  // for how many updates a fat box leaves room
    double wasted_work_ = 0;
    double search_work_ = 0;
    std::int64_t overlap_count_ = 0;
    std::size_t searched_since_sort_ = 0;
    double tests_after_sort_ = 0;  // for each box, when everything was looked up
    bool is_worn_ = false;         // they became more

    // Working memory of an update.
    std::vector<SlotIndex> movers_;
    std::vector<Escaped> escaped_;
    std::vector<SlotIndex> found_;
    std::vector<std::array<SlotIndex, 2>> found_pairs_;
    CandidateLists old_candidates_;
};

}  // namespace ecods
