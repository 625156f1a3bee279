// Defines the list of candidates: pairs of boxes that may overlap during the next updates.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/candidates/slot_table.hpp"
#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// Holds, each once, the pairs of slots whose fat boxes overlap, if at least one slot of the pair is awake. Also stores
// whether the boxes of a pair overlapped when they were last tested.
class CandidateList {
  public:
    using SlotPair = std::array<SlotIndex, 2>;

    // Marks, in the second slot of a stored candidate, that its boxes overlapped at the last test.
    static constexpr SlotIndex overlap_bit = SlotIndex{1} << 31;

    std::size_t size() const noexcept { return pairs_.size(); }
    // Returns how many candidates overlapped when the last test() began.
    std::size_t overlapping_count() const noexcept { return overlapping_count_; }

    void add(SlotIndex a, SlotIndex b, bool do_overlap) { pairs_.push_back({a, b | (do_overlap ? overlap_bit : 0)}); }
    void clear() noexcept {
        pairs_.clear();
        doubtful_.clear();
    }

    // Adds a pair that ceased to be a candidate when a fat box changed, and is a candidate again; the list may still
    // have it. The next test() finds out and avoids a duplicate. The boxes of the pair must not have overlapped at the
    // last test().
    void add_if_new(SlotIndex a, SlotIndex b) { doubtful_.push_back({std::min(a, b), std::max(a, b)}); }

    // Tests all candidates, and appends the pairs that began or ceased to overlap to `events`. Drops the pairs whose
    // fat boxes changed and no longer overlap. The boxes of a dropped pair do not overlap now. If one of the two was
    // removed, they may have overlapped until now; then the end of the pair is reported, unless `are_removed_reported`
    // is true.
    void test(SlotTable& slots, bool are_removed_reported, PairEvents& events);

    // Drops the candidates whose boxes are both asleep.
    void drop_asleep(const SlotTable& slots);

    // Returns the list to which a search appends the pairs of slots whose fat boxes overlap. settle() then tests the
    // boxes of each pair, and drop_asleep() drops the pairs that are no candidates because both boxes are asleep.
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

    // Throws BrokenInvariant unless the list has all candidates of these slots, each once, as a comparison of all boxes
    // finds them. The list may also have pairs that ceased to be candidates when fat boxes changed.
    void validate(const SlotTable& slots) const;

  private:
    void add_doubtful(const SlotTable& slots, PairEvents& events);

    std::vector<SlotPair> pairs_;
    std::vector<SlotPair> doubtful_, there_;  // pairs from add_if_new(), and the pairs among them that pairs_ has
    std::uint64_t overlapping_count_ = 0;
    std::uint32_t tests_by_boxes_ = 0;  // number of next tests that use the boxes themselves, not coarse boxes
};

}  // namespace ecods
