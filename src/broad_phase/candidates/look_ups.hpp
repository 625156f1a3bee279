// Looks up boxes in the forest, some at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/boxes/box_forest.hpp"
#include "broad_phase/candidates/slot_table.hpp"

namespace ecods {

// Looks up slots. Holds scratch, and the partners that the last look-up found.
class LookUps {
  public:
    static constexpr std::size_t part = 128;  // slots looked up at once; their scratch fits in the nearest cache

    // Names a slot, `partner`, whose fat box overlaps the fat box of a query. The pair is not known to be a candidate.
    struct NewPartner {
        std::uint32_t query;  // index of the query among the looked-up slots
        SlotIndex partner;
        bool overlaps;  // true if the boxes overlap, too
    };
    // Says which of the found partners are known to be candidates with the query already.
    struct Known {
        // `looked_up` is the flag of all slots that are looked up together. If two of these slots find each other, only
        // the lower slot reports the pair.
        unsigned looked_up;
        // `has` is a set of flags. A found partner that has all flags of the set is known to be a candidate with the
        // query if the fat box of the partner overlaps the old fat box of the query; all other partners are new.
        unsigned has;
    };

    // Looks up the slots in `wanted`, at most `part`; before, their fat boxes were `old_fats`. Sets found() to their
    // new partners, and returns the number of box tests.
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
