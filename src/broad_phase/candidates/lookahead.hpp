// Chooses the lookahead: the number of updates that margins are meant to last.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ecods {

// Adapts the lookahead so that the cost of wasted tests equals the cost of searches. Wide fat boxes make candidates
// whose tests find no overlap; their number is proportional to the lookahead w. Boxes escape sooner from narrow fat
// boxes; the cost of the searches is inversely proportional to w. The sum of the costs A = a w and B = b / w is least
// where A = B, which is at the lookahead w sqrt(B / A). Costs are summed from one full search (rebuild_rule.hpp) to the
// next, since a full search is most of the work. Costs are counted in tests.
class Lookahead {
  public:
    double updates() const noexcept { return updates_; }

    // Notes the tests of an update: `wasted` tests of candidates that had not overlapped, and `searched` tests in trees
    // for candidates of boxes that escaped. Tests for boxes that jumped do not count: no margin would have avoided
    // them.
    void note(std::size_t wasted, std::uint64_t searched) noexcept {
        // A test in trees costs more than a test of a candidate, since linking and a new fat box come with it.
        constexpr double search_cost = 2;
        wasted_ += static_cast<double>(wasted);
        searched_ += search_cost * static_cast<double>(searched);
    }
    // Notes the tests of a full search. A test of a full search weighs less than a test in trees, since a full search
    // makes many tests at a time, but a full search also sorts boxes and gives boxes margins.
    void note_everything(std::uint64_t tests) noexcept { searched_ += static_cast<double>(tests); }
    void note_update() noexcept { ++updates_since_adapted_; }

    // Returns true if the noted work per box is enough to learn from.
    bool is_due(std::size_t boxes) const noexcept { return wasted_ + searched_ > 512 * static_cast<double>(boxes); }

    void adapt() noexcept {
        constexpr std::size_t updates_min = 2;  // fewer updates show no motion to learn from
        if (updates_since_adapted_ >= updates_min) {
            updates_ *= std::clamp(std::sqrt((searched_ + 1) / (wasted_ + 1)), 0.5, 2.0);
            updates_ = std::clamp(updates_, least, limit_);
        }
        wasted_ = searched_ = 0;
    }

    // Guesses the lookahead before a motion is known, for boxes of similar sizes. The number of wasted tests grows with
    // the number of pairs; the cost of a search does not. So the best lookahead is inversely proportional to the square
    // root of the number of pairs per box. The factor was measured.
    static double guess(std::size_t pairs, std::size_t boxes) noexcept {
        constexpr double for_one_pair = 50;
        const double pairs_per_box = static_cast<double>(pairs + 1) / static_cast<double>(boxes + 1);
        return std::clamp(for_one_pair / std::sqrt(pairs_per_box), least, most);
    }

    // Sets the lookahead when a motion has just begun or changed: to `updates`, but to at most `limit`, the number of
    // updates that margins of fast boxes last.
    void start(double updates, double limit = most) noexcept {
        this->limit(limit);
        updates_ = std::clamp(updates, least, limit_);
        wasted_ = searched_ = 0;
    }
    void limit(double updates) noexcept { limit_ = std::clamp(updates, least, most); }

    // Returns the number of updates noted since all boxes got new margins, and begins to count from 0.
    std::size_t restart() noexcept { return std::exchange(updates_since_adapted_, 0); }

  private:
    static constexpr double least = 2, most = 64;

    double updates_ = 24;
    double limit_ = most;
    double wasted_ = 0, searched_ = 0;
    std::size_t updates_since_adapted_ = 0;
};

}  // namespace ecods
