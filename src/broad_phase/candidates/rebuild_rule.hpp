// Decides when an update searches for the candidates of all boxes at once, which is a full search, instead of looking
// up single boxes.
#pragma once

#include <algorithm>
#include <cstddef>

namespace ecods {

// A RebuildRule chooses between look-ups of single boxes and full searches. Looking up one box costs as much as a full
// search costs for eight boxes. A full search also gives new margins to all boxes that need them soon: after the
// search, boxes that had escaped one by one escape together again.
//
// Boxes drift away from their neighbours in memory and in trees, and added boxes have arbitrary neighbours: after a
// while, slots are sorted again.
class RebuildRule {
  public:
    // Returns true if so many boxes escaped that a full search costs less than looking up the escaped boxes.
    static bool are_many(std::size_t escaped, std::size_t boxes) noexcept { return 8 * escaped > boxes; }

    // Returns true if look-ups of single boxes have cost half as much as a full search. A full search avoids about as
    // many later look-ups of awake boxes. If the last full searches renewed few fat boxes, requires more look-ups
    // before the next full search.
    bool is_due(std::size_t awake, std::size_t boxes) const noexcept {
        return 2 * awake > boxes && 16 * looked_up_ > boxes << patience_;
    }

    // Returns true if so many slots are out of order that searching the trees has become slow.
    bool is_degraded(std::size_t unsorted, std::size_t slots, std::size_t boxes) const noexcept {
        return searched_ > 4 * boxes || 4 * unsorted > boxes + 64 || slots > 2 * boxes + 64;
    }

    // Notes that a full search will give new fat boxes to `escaped` boxes, of which `came` were added. Returns true if
    // the slots should be sorted. Call before each full search.
    bool is_order_due(std::size_t escaped, std::size_t came, std::size_t boxes) noexcept {
        constexpr std::size_t escapes_per_sort = 8;
        escaped_ += escaped;
        return are_many(came, boxes) || escaped_ > escapes_per_sort * boxes;
    }

    void note_looked_up(std::size_t escaped) noexcept {
        searched_ += escaped;
        looked_up_ += escaped;
    }
    // Sets the patience after a full search: to 0 if the search renewed more than half of the fat boxes, otherwise two
    // steps higher, up to a maximum. Restarts the count of look-ups.
    void note_everything(std::size_t renewed, std::size_t boxes) noexcept {
        constexpr unsigned patience_max = 6;
        patience_ = 2 * renewed > boxes ? 0 : std::min(patience_ + 2, patience_max);
        looked_up_ = 0;
    }
    void note_order() noexcept { searched_ = escaped_ = 0; }

  private:
    std::size_t searched_ = 0;   // boxes that escaped and were looked up, since slots were sorted
    std::size_t escaped_ = 0;    // boxes that escaped in full searches, since slots were sorted
    std::size_t looked_up_ = 0;  // boxes that escaped and were looked up, since the last full search
    unsigned patience_ = 0;      // log2 of the factor by which more boxes are looked up before the next search
};

}  // namespace ecods
