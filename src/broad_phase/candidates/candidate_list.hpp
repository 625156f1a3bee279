// Pairs that may overlap for a while.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/candidates/slot_table.hpp"
#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// Pairs of slots whose fat boxes overlap, one of the two awake, each once; and whether their boxes overlapped when they
// were last tested.
class CandidateList {
  public:
    using SlotPair = std::array<SlotIndex, 2>;

    // In the second one of a candidate, as they are stored: they overlapped.
    static constexpr SlotIndex overlap_bit = SlotIndex{1} << 31;

    std::size_t size() const noexcept { return pairs_.size(); }
    std::size_t overlapping_count() const noexcept { return overlapping_count_; }  // before the last test

    void add(SlotIndex a, SlotIndex b, bool do_overlap) { pairs_.push_back({a, b | (do_overlap ? overlap_bit : 0)}); }
    void clear() noexcept {
        pairs_.clear();
        doubtful_.clear();
    }

    // Adds a pair that may be here already: one that was none any more since a fat box changed, and is one again. Its
    // boxes did not overlap. The next test finds out.
    void add_if_new(SlotIndex a, SlotIndex b) { doubtful_.push_back({std::min(a, b), std::max(a, b)}); }

    // Tests all, and reports those that began or ceased to overlap. What is no candidate any more since fat boxes
    // changed goes: it does not overlap, but for pairs of a slot that was removed, which end unless they are reported
    // already.
    void test(SlotTable& slots, bool are_removed_reported, PairEvents& events);

    // Those of boxes that are asleep go.
    void drop_asleep(const SlotTable& slots);

    // Where a search puts the pairs of fat boxes that overlap. settle() makes them the candidates, until drop_asleep().
    std::vector<SlotPair>& found() noexcept { return pairs_; }
    void settle(const SlotTable& slots);

    // Calls visit(a, b) with the proxies of each candidate whose boxes overlapped when it was last tested.
    template <class Visit>
    void for_each_overlapping(const SlotTable& slots, const Visit& visit) const {
        const ProxyIndex* const proxies = slots.proxies().data();
        for (const auto& [a, b] : pairs_) {
            if (b >= overlap_bit) visit(proxies[a], proxies[b & ~overlap_bit]);
        }
    }

    void release_spare() { pairs_.shrink_to_fit(); }
    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless these are the candidates of these slots: all of them, from the boxes alone; and
    // some that were before fat boxes changed.
    void validate(const SlotTable& slots) const;

  private:
    void add_doubtful(const SlotTable& slots, PairEvents& events);

    std::vector<SlotPair> pairs_;
    std::vector<SlotPair> doubtful_, there_;  // those that may be here, and those of them that are
    std::uint64_t overlapping_count_ = 0;
    std::uint32_t tests_by_boxes_ = 0;  // so many more are made by the boxes themselves, not by coarse ones
};

}  // namespace ecods
