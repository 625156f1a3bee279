// The boxes of which candidates are kept, by slot.
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

// A box that left its fat box, or came.
struct EscapedBox {
    SlotIndex slot;
    PackedBox before;  // the box that it was before the update
};

struct SlotView;  // slot_table_move.cpp

// Makes `values` those of the slots in this order, and leaves out the others.
template <class Value>
void reorder_values(std::vector<Value>& values, std::span<const SlotIndex> order) {
    std::vector<Value> ordered;
    ordered.reserve(order.size() + order.size() / 32);  // lest the first one that comes copies all
    ordered.resize(order.size());
    for (std::size_t slot = 0; slot < order.size(); ++slot) ordered[slot] = values[order[slot]];
    values = std::move(ordered);
}

// Boxes and their fat boxes in slots, numbered so that neighbours are close in memory, and what is known of each. Fat
// boxes are in a frame of their own; free slots have empty boxes.
class SlotTable {
  public:
    enum Flag : std::uint8_t {
        awake = 1,
        moved = 2,    // since boxes were last put to sleep
        changed = 4,  // its fat box did, or it went: some of its candidates may be none any more
        escaped = 8,  // during an update: it has another fat box than before
        woken = 16,   // while boxes awake: its candidates are known
    };

    void reserve(std::size_t count);

    std::size_t size() const noexcept { return lines_.size(); }  // free slots included
    std::size_t used_count() const noexcept { return used_count_; }
    std::size_t awake_count() const noexcept { return awake_count_; }

    std::span<const PackedBox> lines() const noexcept { return lines_; }
    std::span<const CoarseBox> coarse_boxes() const noexcept {
        return coarse_boxes_;
    }  // of the lines, if they are kept
    std::span<const PackedBox> fat_lines() const noexcept { return fat_lines_; }
    std::span<const ProxyIndex> proxies() const noexcept { return proxies_; }
    std::span<const std::uint8_t> flags() const noexcept { return flags_; }
    SlotIndex slot_of(ProxyIndex proxy) const noexcept { return slots_[proxy]; }
    bool keeps_coarse_boxes() const noexcept { return !coarse_boxes_.empty(); }
    bool is_free(SlotIndex slot) const noexcept { return lines_[slot].is_empty(); }
    bool has(SlotIndex slot, unsigned flag) const noexcept { return (flags_[slot] & flag) != 0; }
    ProxyPair pair_of(SlotIndex a, SlotIndex b) const noexcept { return ordered_pair(proxies_[a], proxies_[b]); }
    void prefetch(SlotIndex slot) const noexcept;

    // ---- coarse boxes: not worth their memory where nearly all boxes are asleep
    void choose_coarse_boxes();

    // ---- coming and going
    SlotIndex add(ProxyIndex proxy, const Aabb& box);  // without a fat box, asleep

    // Leaves an empty box. The slot is changed, and is used again when changes are forgotten.
    void remove(SlotIndex slot);

    // ---- moving: copies boxes from the table, and appends those that left their fat boxes
    void move_range(std::size_t begin, std::size_t end, const ProxyTable& table, const MovingFrame& frame,
                    std::vector<EscapedBox>& escaped);  // of all slots, in the order of memory
    void move(std::span<const ProxyIndex> proxies, const ProxyTable& table, const MovingFrame& frame,
              std::vector<EscapedBox>& escaped);

    // Copies boxes from the table; leaves fat boxes stale, and drops coarse ones.
    void take(std::span<const ProxyIndex> proxies, const ProxyTable& table);

    // Gives a slot another fat box; it has escaped, until that flag is cleared.
    void set_fat(SlotIndex slot, const PackedBox& fat) noexcept {
        fat_lines_[slot] = fat;
        flags_[slot] |= escaped;
    }

    // All fat boxes are the boxes.
    void drop_margins() { fat_lines_ = lines_; }

    // ---- being awake
    std::size_t count_asleep(std::span<const ProxyIndex> proxies) const noexcept;
    void note_moved(SlotIndex slot) noexcept { flags_[slot] |= moved; }
    void wake(SlotIndex slot) noexcept;
    void note_woken(SlotIndex slot) noexcept { flags_[slot] |= woken; }
    void settle_woken(std::span<const SlotIndex> slots) noexcept;

    // Before its candidates are looked for: a slot has another fat box, which contains the box, too.
    void widen(SlotIndex slot, const PackedBox& fat);
    void put_all_to_sleep() noexcept;

    // Puts boxes to sleep whose cost awake has reached the cost of one wake-up, after an update in which so many moved.
    // Returns whether it looked for such boxes.
    bool put_resting_to_sleep(std::size_t moved_count) noexcept;

    // ---- changes
    const std::vector<SlotIndex>& changed_slots() const noexcept { return changed_slots_; }
    void settle_escaped(std::span<const EscapedBox> escaped);  // they have changed
    void settle_all_escaped() noexcept;                        // of an update that forgot changes
    void mark_changed() noexcept;  // their coarse boxes, until changes are forgotten or boxes move
    void forget_changes();

    // Puts the slots named in this order, and leaves out the others, which must be free.
    void reorder(std::span<const SlotIndex> order);

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless boxes, proxies and counts agree with the table. Fat boxes are looked at if there
    // are any.
    void validate(const ProxyTable& table, const MovingFrame& frame, bool has_margins) const;

  private:
    SlotView view() noexcept;
    void note_changed(SlotIndex slot);
    void clear(SlotIndex slot, unsigned flag) noexcept { flags_[slot] &= static_cast<std::uint8_t>(~flag); }

    std::vector<PackedBox> lines_;
    std::vector<CoarseBox> coarse_boxes_;  // none unless they are kept
    std::vector<PackedBox> fat_lines_;
    std::vector<ProxyIndex> proxies_;
    std::vector<std::uint8_t> flags_;
    std::vector<SlotIndex> slots_;  // by proxy
    std::vector<SlotIndex> free_slots_;
    std::vector<SlotIndex> changed_slots_;  // those with the flag
    std::size_t used_count_ = 0;            // slots that are not free
    std::size_t awake_count_ = 0;
    std::uint64_t updates_at_rest_ = 0;  // updates in which an awake box did not move, summed
};

}  // namespace ecods
