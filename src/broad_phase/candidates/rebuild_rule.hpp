// When single boxes are looked up no more, and everything is searched for.
#pragma once

#include <algorithm>
#include <cstddef>

namespace ecods {

// Looking up a box costs as much as the shares of eight in a search for everything, which gives all that need it soon
// new margins, too: where boxes escape one by one, the next ones escape with all others again. And boxes drift away
// from those that they are beside in memory and in trees, and those that came are beside any: then slots are put in
// order.
class RebuildRule {
  public:
    // True if so many of the boxes that are there escaped that all are searched for.
    static bool are_many(std::size_t escaped, std::size_t boxes) noexcept { return 8 * escaped > boxes; }

    // Whether single ones have been looked up for half of what it costs to search for everything, which spares the same
    // to those that are awake. Where that was not so, more are looked up before the next time.
    bool is_due(std::size_t awake, std::size_t boxes) const noexcept {
        return 2 * awake > boxes && 16 * looked_up_ > boxes << patience_;
    }

    // True if too many slots are out of order to search the trees well.
    bool is_degraded(std::size_t unsorted, std::size_t slots, std::size_t boxes) const noexcept {
        return searched_ > 4 * boxes || 4 * unsorted > boxes + 64 || slots > 2 * boxes + 64;
    }

    // Before a search for everything, in which so many have escaped, of which some came: whether it is time for that.
    bool is_order_due(std::size_t escaped, std::size_t came, std::size_t boxes) noexcept {
        constexpr std::size_t escapes_per_sort = 8;
        escaped_ += escaped;
        return are_many(came, boxes) || escaped_ > escapes_per_sort * boxes;
    }

    void note_looked_up(std::size_t escaped) noexcept {
        searched_ += escaped;
        looked_up_ += escaped;
    }
    // A search for everything gave so many another fat box.
    void note_everything(std::size_t renewed, std::size_t boxes) noexcept {
        constexpr unsigned patience_max = 6;
        patience_ = 2 * renewed > boxes ? 0 : std::min(patience_ + 2, patience_max);
        looked_up_ = 0;
    }
    void note_order() noexcept { searched_ = escaped_ = 0; }

  private:
    std::size_t searched_ = 0;   // boxes that escaped and were looked up, since slots were put in order
    std::size_t escaped_ = 0;    // that escaped in searches for everything, since then
    std::size_t looked_up_ = 0;  // that escaped and were looked up, since the last such search
    unsigned patience_ = 0;      // so many times twice as many are looked up before the next one
};

}  // namespace ecods
