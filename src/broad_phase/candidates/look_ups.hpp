// Boxes that are looked up in the forest, some at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/candidates/slot_table.hpp"

namespace ecods {

// Working memory of those look-ups, and what they found.
class LookUps {
  public:
    static constexpr std::size_t part = 128;  // are looked up at once: what they take is in the nearest cache

    // One that a fat box overlaps, and is no candidate with it yet, as far as is known.
    struct NewPartner {
        std::uint32_t query;  // its place among those looked up
        SlotIndex partner;
        bool overlaps;  // do the boxes?
    };
    // Which of those found are known already.
    struct Known {
        unsigned looked_up;  // the flag of all that are looked up: of two of them, the first finds the other
        unsigned has;        // of others: the flags of one that was a candidate where its fat box overlaps the old one
    };

    // Looks up at most `part` slots, whose fat boxes were `old_fats` before. Returns the number of box tests.
    std::uint64_t find(std::span<const SlotIndex> wanted, std::span<const PackedBox> old_fats, const Known& known,
                       const SlotTable& slots, const BoxForest& fat_boxes);
    std::span<const NewPartner> found() const noexcept { return {partners_.data(), partner_count_}; }
    std::size_t bytes() const noexcept;

  private:
    std::vector<BoxReach> reaches_;
    BlockVisits visits_;
    std::vector<FoundBox> found_;
    std::vector<NewPartner> partners_;  // and more, for nothing is allocated in between
    std::size_t partner_count_ = 0;
};

}  // namespace ecods
