// Trees of the fat boxes, for looking up few.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"

namespace ecods {

// A search for everything needs no trees, and leaves them behind: they are brought up to date when a box is looked up
// again.
class FatForest {
  public:
    bool is_behind() const noexcept { return is_behind_; }

    // Fat boxes have changed; slots are those that they were.
    void leave_behind() noexcept { is_behind_ = true; }

    // Slots have other numbers: trees are built from scratch when they are needed.
    void forget() noexcept;

    // Makes the trees those of these fat boxes. Cost: a constant, unless they were left behind.
    void refresh(std::span<const PackedBox> fat_lines);

    // A slot that is free from now on.
    void remove(SlotIndex slot) {
        if (!is_forgotten_) forest_.remove(slot);
    }

    // Puts slots into the trees: those that were removed or never there; at once, or when trees are brought up to date.
    void add(std::span<const SlotIndex> slots, std::span<const PackedBox> fat_lines);

    // Of trees that are up to date: a slot has another fat box.
    void set(SlotIndex slot, const PackedBox& fat_line) { forest_.set(slot, fat_line); }
    void prefetch(SlotIndex slot) const noexcept { forest_.prefetch(slot); }

    // The trees, which must be up to date.
    const BoxForest& trees() const noexcept {
        ECODS_ASSERT(!is_behind_);
        return forest_;
    }

    // Slots that are, or will be, in trees which are not in order.
    std::size_t unsorted_count() const noexcept { return forest_.unsorted_count() + lacking_.size(); }

    std::size_t bytes() const noexcept;
    void validate(std::span<const PackedBox> fat_lines) const;

  private:
    BoxForest forest_;
    bool is_behind_ = true;
    bool is_forgotten_ = true;
    std::vector<SlotIndex> lacking_;  // to be put into trees that are behind; some of them twice, or free by now
};

}  // namespace ecods
