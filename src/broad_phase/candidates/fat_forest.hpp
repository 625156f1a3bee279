// Defines the trees of fat boxes, in which a few boxes at a time are looked up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"

namespace ecods {

// Keeps trees over the fat boxes of all slots, and updates them lazily. A full search (rebuild_rule.hpp) needs no trees
// and leaves the trees stale; the next look-up brings the trees up to date.
class FatForest {
  public:
    bool is_behind() const noexcept { return is_behind_; }

    // Marks the trees as stale after fat boxes changed. Slots must have kept their numbers.
    void leave_behind() noexcept { is_behind_ = true; }

    // Invalidates the trees after slots were renumbered: the next refresh() builds them from scratch.
    void forget() noexcept;

    // Brings the trees up to date with these fat boxes. Cost: constant if they are up to date already.
    void refresh(std::span<const PackedBox> fat_lines);

    // Removes a slot that is free from now on.
    void remove(SlotIndex slot) {
        if (!is_forgotten_) forest_.remove(slot);
    }

    // Puts slots into the trees, and removes them from their old positions if they have any. If the trees are stale,
    // the next refresh() puts the slots in.
    void add(std::span<const SlotIndex> slots, std::span<const PackedBox> fat_lines);

    // Sets the fat box of a slot. The trees must be up to date.
    void set(SlotIndex slot, const PackedBox& fat_line) { forest_.set(slot, fat_line); }
    void prefetch(SlotIndex slot) const noexcept { forest_.prefetch(slot); }

    // Returns the trees, which must be up to date.
    const BoxForest& trees() const noexcept {
        ECODS_ASSERT(!is_behind_);
        return forest_;
    }

    // Returns the number of slots that are in unsorted trees, or will be put into one by refresh().
    std::size_t unsorted_count() const noexcept { return forest_.unsorted_count() + lacking_.size(); }

    std::size_t bytes() const noexcept;
    void validate(std::span<const PackedBox> fat_lines) const;

  private:
    BoxForest forest_;
    bool is_behind_ = true;
    bool is_forgotten_ = true;
    std::vector<SlotIndex> lacking_;  // slots to put into stale trees; may have duplicates and free slots
};

}  // namespace ecods
