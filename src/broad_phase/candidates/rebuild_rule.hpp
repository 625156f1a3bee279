// When single boxes are looked up no more, and everything is searched for.
#pragma once

#include <cstddef>

namespace ecods {

// Looking up a box costs more than its share of a search for everything. And boxes drift away from those that they are
// beside in memory and in trees, and those that came are beside any: then slots are put in order.
class RebuildRule {
  public:
    // Of the boxes that are there.
    static bool are_many(std::size_t escaped, std::size_t boxes) noexcept { return 8 * escaped > boxes; }

    // Whether slots must be put in order: they, and the trees, have so many boxes that are not.
    bool is_degraded(std::size_t unsorted, std::size_t slots, std::size_t boxes) const noexcept {
        return searched_ > 4 * boxes || 4 * unsorted > boxes + 64 || slots > 2 * boxes + 64;
    }

    // Before a search for everything, in which so many have escaped, of which some came: whether it is time for that.
    bool is_order_due(std::size_t escaped, std::size_t came, std::size_t boxes) noexcept {
        constexpr std::size_t escapes_per_sort = 8;
        escaped_ += escaped;
        return are_many(came, boxes) || escaped_ > escapes_per_sort * boxes;
    }

    void note_searched(std::size_t escaped) noexcept { searched_ += escaped; }
    void note_order() noexcept { searched_ = escaped_ = 0; }

  private:
    std::size_t searched_ = 0;  // boxes that escaped and were looked up, since slots were put in order
    std::size_t escaped_ = 0;   // that escaped in searches for everything, since then
};

}  // namespace ecods
