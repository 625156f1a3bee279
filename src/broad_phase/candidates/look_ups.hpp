// Looks up boxes in the forest, some at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/candidates/slot_table.hpp"

namespace ecods {

// Holds the scratch of look-ups, and the partners that the last one found.
class LookUps {
  public:
    static constexpr std::size_t part = 128;  // slots looked up at once; their scratch fits in the nearest cache

    // A slot whose fat box overlaps the fat box of a query, and which is not known to be a candidate with it already.
    struct NewPartner {
        std::uint32_t query;  // index of the query among the looked-up slots
        SlotIndex partner;
        bool overlaps;  // true if the boxes overlap, too
    };
    // Says which of the partners found are known already.
    struct Known {
        // The flag of all slots that are looked up. If two of them find each other, only the lower slot reports the
        // pair.
        unsigned looked_up;
        // The flags of other partners that may be known: a partner with all of them was a candidate if its fat box
        // overlaps the old fat box of the query.
        unsigned has;
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
    std::vector<NewPartner> partners_;  // has space for all found boxes, so that the filter does not allocate
    std::size_t partner_count_ = 0;
};

}  // namespace ecods
