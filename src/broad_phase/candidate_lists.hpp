// Which boxes may overlap, kept for many updates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/box_tree.hpp"

namespace ecods {

// A candidate is a pair of slots and whether they overlapped when they were last tested. It is in the lists of both,
// so that what a box may touch is at hand, and owned by one of them, so that all candidates can be gone through once.
// Each entry knows its mirror, the entry in the other's list: changing or removing a candidate costs a constant, also
// when the other is a box with a hundred thousand candidates.
class CandidateLists {
  public:
    // An entry is the partner's slot, and this bit if they overlap.
    static constexpr std::uint32_t overlap_bit = std::uint32_t{1} << 31;
    static constexpr SlotIndex slot_of(std::uint32_t entry) noexcept { return entry & ~overlap_bit; }
    static constexpr bool overlaps(std::uint32_t entry) noexcept { return (entry & overlap_bit) != 0; }

    // Starts anew: `count` slots with these candidates, none of them overlapping so far; the first of two is the owner.
    void build(std::size_t count, std::span<const std::array<SlotIndex, 2>> pairs);

    // Numbers the slots anew: what was old_slots[i] is i. Slots that are in no candidate may be left out.
    void renumber(std::span<const SlotIndex> old_slots);

    // Makes the lists of new slots.
    void resize(std::size_t count) { lists_.resize(count); }

    // The entries of a slot; those that it owns come first.
    std::span<const std::uint32_t> entries(SlotIndex slot) const noexcept {
        return {partners_.data() + lists_[slot].begin, lists_[slot].count};
    }
    std::uint32_t owned_count(SlotIndex slot) const noexcept { return lists_[slot].owned; }
    std::size_t slot_count() const noexcept { return lists_.size(); }
    std::size_t size() const noexcept { return size_; }  // candidates

    void add(SlotIndex owner, SlotIndex other, bool overlap);
    void remove(SlotIndex slot, std::uint32_t index);

    // Turns the overlap bit of an entry and of its mirror.
    void flip(SlotIndex slot, std::uint32_t index) noexcept {
        const std::size_t at = lists_[slot].begin + index;
        const std::uint32_t entry = partners_[at] ^= overlap_bit;
        partners_[lists_[slot_of(entry)].begin + mirrors_[at]] ^= overlap_bit;
    }

    std::size_t bytes() const noexcept;

    // Throws BrokenInvariant unless mirrors mirror each other and each candidate is there once, with one owner.
    void validate() const;

  private:
    struct List {
        std::size_t begin = 0;
        std::uint32_t capacity = 0;
        std::uint32_t owned = 0;
        std::uint32_t count = 0;
    };

    void grow(SlotIndex slot);
    void compact();
    void put(SlotIndex slot, std::uint32_t index, std::uint32_t entry, std::uint32_t mirror);
    void move_entry(SlotIndex slot, std::uint32_t from, std::uint32_t to);
    std::uint32_t make_room(SlotIndex slot, bool is_owned);

    std::vector<List> lists_;
    std::vector<std::uint32_t> partners_;
    std::vector<std::uint32_t> mirrors_;  // the index of the mirror in the partner's list
    std::size_t size_ = 0;
};

}  // namespace ecods
