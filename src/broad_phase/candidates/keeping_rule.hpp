// Decides when keeping candidates pays, and when a search from scratch in each update costs less.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ecods {

// A KeepingRule decides from counts alone, never from clocks, if updates keep candidates, so that runs are repeatable.
// The unit of work is about a nanosecond, as measured for 10,000 boxes on one machine (bench, suite broad). Only the
// ratios of estimates matter, and no answer depends on an estimate.
class KeepingRule {
  public:
    // Holds estimates for an update, made before it.
    struct Forecast {
        std::size_t boxes;
        std::size_t moved;
        std::size_t came;
        double jumping;       // number of moved boxes that are too fast for any margin
        double step;          // median step of a moved box in an update, as a share of its extent
        double lifetime_max;  // largest number of updates that margins can last
    };
    // Holds the counts of an update that kept candidates.
    struct Kept {
        std::size_t boxes, moved;
        std::uint64_t filtered, events, looked_up, tree_tests;  // events: without the events of a full search
        bool searched_all;
        std::size_t candidates;  // number of candidates after a full search
    };

    // Returns true if the last decision was to keep nothing: then the next update makes a full search.
    bool searches() const noexcept { return is_scratch_; }

    // Returns true if boxes have margins from now on, and then sets lifetime(). Otherwise returns false. Call only in
    // an update that makes a full search.
    bool pays(const Forecast& forecast) noexcept;
    double lifetime() const noexcept { return lifetime_; }  // number of updates that these margins shall last

    // Notes the number of pairs after an update that made a full search.
    void note_pairs(std::size_t count) noexcept { pairs_ = count; }
    std::size_t pairs() const noexcept { return pairs_; }

    // Notes the work of an update that kept candidates. If keeping has cost more than searches from scratch would have,
    // the next updates search from scratch. The number of these updates doubles each time that this happens, up to a
    // maximum.
    void note_kept(const Kept& kept) noexcept;

  private:
    // Returns the work of a search from scratch. Measured per box: 80 if boxes are sparse, with 0.14 pairs a box; 140
    // if they are dense, with 2.4; 330 in clusters, with 8.5.
    double scratch_work(double boxes) const noexcept { return 75 * boxes + 28 * static_cast<double>(pairs_); }

    // Returns the work of a search that gives margins and finds candidates. Measured per box: 150 if boxes are sparse,
    // with 0.3 candidates a box; 240 if they are dense, with 4.
    static double search_work(double boxes, double candidates) noexcept { return 120 * boxes + 30 * candidates; }

    double kept_work(const Forecast& forecast, double lifetime) const noexcept;

    bool is_scratch_ = false;
    std::size_t pairs_ = 0;
    double lifetime_ = 0;
    double lost_ = 0;  // work of keeping minus work from scratch, summed since the last decision to keep
    std::uint32_t trial_patience_ = 4;
    std::uint32_t updates_to_trial_ = 0;
};

}  // namespace ecods
