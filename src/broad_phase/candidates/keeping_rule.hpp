// When keeping candidates pays, and when a search from scratch at each update costs less.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ecods {

// Decides from counts alone, never from clocks, so that runs repeat. Work is in units of about a nanosecond, measured
// of 10,000 boxes on one machine (bench, suite broad): only ratios matter, and no answer depends on them.
class KeepingRule {
  public:
    // What is known of an update before it.
    struct Forecast {
        std::size_t boxes;
        std::size_t moved;
        std::size_t came;
        double jumping;       // so many of those that move are too fast for any margin
        double step;          // in an update, of a moved box of the middle, as a share of its extent
        double lifetime_max;  // updates for which margins may last
    };
    // What an update did that kept candidates.
    struct Kept {
        std::size_t boxes, moved;
        std::uint64_t filtered, events, looked_up, tree_tests;  // no events of one that searched everything
        bool searched_all;
        std::size_t candidates;  // after that search
    };

    // Whether the last decision was to keep nothing: then the next update searches for everything.
    bool searches() const noexcept { return is_scratch_; }

    // For an update that searches for everything: whether boxes are to have margins from then on.
    bool pays(const Forecast& forecast) noexcept;
    double lifetime() const noexcept { return lifetime_; }  // for how many updates they are to last then

    // After an update that searched for everything: the pairs there are.
    void note_pairs(std::size_t count) noexcept { pairs_ = count; }
    std::size_t pairs() const noexcept { return pairs_; }

    // After an update that kept candidates. Where they have cost more than searches from scratch would have, the
    // updates that follow are such, and the more of them the more often that was so.
    void note_kept(const Kept& kept) noexcept;

  private:
    // A search from scratch: 80 a box of sparse ones with 0.14 pairs each, 140 of dense ones with 2.4, 330 in clusters
    // with 8.5.
    double scratch_work(double boxes) const noexcept { return 75 * boxes + 28 * static_cast<double>(pairs_); }

    // One that gives margins and finds candidates: 150 a box of sparse ones with 0.3 candidates each, 240 of dense ones
    // with 4.
    static double search_work(double boxes, double candidates) noexcept { return 120 * boxes + 30 * candidates; }

    double kept_work(const Forecast& forecast, double lifetime) const noexcept;

    bool is_scratch_ = false;
    std::size_t pairs_ = 0;
    double lifetime_ = 0;
    double lost_ = 0;  // by keeping, since candidates were first kept
    std::uint32_t trial_patience_ = 4;
    std::uint32_t updates_to_trial_ = 0;
};

}  // namespace ecods
