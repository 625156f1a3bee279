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
        std::size_t looked_up;  // boxes that come
        double lifetime;        // updates for which a margin would last: a moved box of the middle
        double growth;          // of the pairs, by margins that last so long
    };
    // What an update did that kept candidates.
    struct Kept {
        std::size_t boxes, moved;
        std::uint64_t filtered, looked_up, tree_tests;
        bool searched_all;
        std::size_t candidates;  // after that search
    };

    // Whether the last decision was to keep nothing: then the next update searches for everything.
    bool searches() const noexcept { return is_scratch_; }

    // For an update that searches for everything: whether boxes are to have margins from then on.
    bool pays(const Forecast& forecast) noexcept;

    // After an update that searched for everything: the pairs there are.
    void note_pairs(std::size_t count) noexcept { pairs_ = static_cast<double>(count); }

    // After an update that kept candidates. Where they have cost more than searches from scratch would have, the
    // updates that follow are such, and the more of them the more often that was so.
    void note_kept(const Kept& kept) noexcept;

  private:
    // A search from scratch: 80 a box of sparse ones with 0.14 pairs each, 140 of dense ones with 2.4, 330 in clusters
    // with 8.5.
    double scratch_work(double boxes) const noexcept { return 75 * boxes + 28 * pairs_; }

    // One that gives margins and finds candidates: 150 a box of sparse ones with 0.3 candidates each, 240 of dense ones
    // with 4.
    static double search_work(double boxes, double candidates) noexcept { return 120 * boxes + 30 * candidates; }

    bool is_scratch_ = false;
    double pairs_ = 0;
    double lost_ = 0;  // by keeping, since candidates were first kept
    std::uint32_t trial_patience_ = 4;
    std::uint32_t updates_to_trial_ = 0;
};

}  // namespace ecods
