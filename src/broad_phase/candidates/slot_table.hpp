// Stores, by slot, the boxes whose candidates are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "broad_phase/boxes/box_tree.hpp"
#include "broad_phase/boxes/coarse_box.hpp"
#include "broad_phase/candidates/moving_frame.hpp"
#include "broad_phase/changes/pair_events.hpp"
#include "broad_phase/changes/proxy_table.hpp"

namespace ecods {

// Holds a box that left its fat box, or was added.
struct EscapedBox {
    SlotIndex slot;
    PackedBox before;  // the box as it was before the update
};

struct SlotView;  // slot_table_move.cpp

// Sets values[i] to the value of the slot order[i], for all i, and drops the other values.
template <class Value>
void reorder_values(std::vector<Value>& values, std::span<const SlotIndex> order) {
    std::vector<Value> ordered;
    ordered.reserve(order.size() + order.size() / 32);  // so that the next box added does not copy all
    ordered.resize(order.size());
    for (std::size_t slot = 0; slot < order.size(); ++slot) ordered[slot] = values[order[slot]];
    values = std::move(ordered);
}

// Holds boxes, their fat boxes and flags in slots. Slots are numbered so that neighbours are close in memory. Fat boxes
// are in a frame of their own (moving_frame.hpp); free slots have empty boxes.
class SlotTable {
  public:
    enum Flag : std::uint8_t {
        awake = 1,
        moved = 2,    // has moved since boxes were last put to sleep
        changed = 4,  // its fat box changed, or it was removed: some of its pairs may be no candidates any more
        escaped = 8,  // during an update: has a new fat box
        woken = 16,   // during KeptCandidates::wake(): the box is being woken
    };

    void reserve(std::size_t count);

    std::size_t size() const noexcept { return lines_.size(); }  // includes free slots
    std::size_t used_count() const noexcept { return used_count_; }
    std::size_t awake_count() const noexcept { return awake_count_; }

    std::span<const PackedBox> lines() const noexcept { return lines_; }
    // Returns the coarse boxes of lines(); empty unless they are kept.
    std::span<const CoarseBox> coarse_boxes() const noexcept { return coarse_boxes_; }
    std::span<const PackedBox> fat_lines() const noexcept { return fat_lines_; }
    std::span<const ProxyIndex> proxies() const noexcept { return proxies_; }
    std::span<const std::uint8_t> flags() const noexcept { return flags_; }
    SlotIndex slot_of(ProxyIndex proxy) const noexcept { return slots_[proxy]; }
    bool keeps_coarse_boxes() const noexcept { return !coarse_boxes_.empty(); }
    bool is_free(SlotIndex slot) const noexcept { return lines_[slot].is_empty(); }
    bool has(SlotIndex slot, unsigned flag) const noexcept { return (flags_[slot] & flag) != 0; }
    ProxyPair pair_of(SlotIndex a, SlotIndex b) const noexcept { return ordered_pair(proxies_[a], proxies_[b]); }
    void prefetch(SlotIndex slot) const noexcept;

    // Makes or drops the coarse boxes, which are not worth their memory if nearly all boxes are asleep.
    void choose_coarse_boxes();

    // add() and remove() put boxes into slots and take them out.
    SlotIndex add(ProxyIndex proxy, const Aabb& box);  // the slot is asleep and has no fat box

    // Sets the box of a slot to the empty one, and marks the slot as changed. The slot is used again after
    // forget_changes().
    void remove(SlotIndex slot);

    // move_range() and move() copy boxes from the table, and append the boxes that left their fat boxes to `escaped`.
    void move_range(std::size_t begin, std::size_t end, const ProxyTable& table, const MovingFrame& frame,
                    std::vector<EscapedBox>& escaped);  // for slots begin to end, in the order of memory
    void move(std::span<const ProxyIndex> proxies, const ProxyTable& table, const MovingFrame& frame,
              std::vector<EscapedBox>& escaped);

    // Copies boxes from the table, leaves fat boxes stale, and drops coarse boxes.
    void take(std::span<const ProxyIndex> proxies, const ProxyTable& table);

    // Gives a slot a new fat box, and sets its flag `escaped`, which settle_escaped() or settle_all_escaped() clears.
    void set_fat(SlotIndex slot, const PackedBox& fat) noexcept {
        fat_lines_[slot] = fat;
        flags_[slot] |= escaped;
    }

    // Sets all fat boxes to the boxes.
    void drop_margins() { fat_lines_ = lines_; }

    // The functions down to put_resting_to_sleep() read and change which slots are awake.
    std::size_t count_asleep(std::span<const ProxyIndex> proxies) const noexcept;
    void note_moved(SlotIndex slot) noexcept { flags_[slot] |= moved; }
    void wake(SlotIndex slot) noexcept;
    void note_woken(SlotIndex slot) noexcept { flags_[slot] |= woken; }
    void settle_woken(std::span<const SlotIndex> slots) noexcept;

    // Gives a slot a new fat box, which must also contain its present box. Call before the slot's candidates are looked
    // up.
    void widen(SlotIndex slot, const PackedBox& fat);
    void put_all_to_sleep() noexcept;

    // Puts the awake boxes to sleep that have not moved since the last pass of this function, and returns true. Returns
    // false, without a pass, until awake boxes at rest have cost as much as the pass. Call after each update;
    // `moved_count` boxes moved in it.
    bool put_resting_to_sleep(std::size_t moved_count) noexcept;

    // The functions down to forget_changes() handle slots whose fat boxes changed.
    const std::vector<SlotIndex>& changed_slots() const noexcept { return changed_slots_; }
    void settle_escaped(std::span<const EscapedBox> escaped);  // clears the flag, and notes the slots as changed
    void settle_all_escaped() noexcept;                        // clears the flag after changes were forgotten
    // Marks the coarse boxes of changed slots, until changes are forgotten or boxes move.
    void mark_changed() noexcept;
    void forget_changes();

    // Renumbers slots: order[i] becomes slot i. The slots that are not in `order` must be free, and are dropped.
    void reorder(std::span<const SlotIndex> order);

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless boxes, proxies and counts agree with the table. Checks fat boxes only if
    // `has_margins` is true.
    void validate(const ProxyTable& table, const MovingFrame& frame, bool has_margins) const;

  private:
    SlotView view() noexcept;
    void note_changed(SlotIndex slot);
    void clear(SlotIndex slot, unsigned flag) noexcept { flags_[slot] &= static_cast<std::uint8_t>(~flag); }

    std::vector<PackedBox> lines_;
    std::vector<CoarseBox> coarse_boxes_;  // empty unless they are kept
    std::vector<PackedBox> fat_lines_;
    std::vector<ProxyIndex> proxies_;
    std::vector<std::uint8_t> flags_;
    std::vector<SlotIndex> slots_;  // by proxy
    std::vector<SlotIndex> free_slots_;
    std::vector<SlotIndex> changed_slots_;  // slots with the flag `changed`
    std::size_t used_count_ = 0;            // slots that are not free
    std::size_t awake_count_ = 0;
    std::uint64_t updates_at_rest_ = 0;  // number of updates in which an awake box did not move, summed over boxes
};

}  // namespace ecods
