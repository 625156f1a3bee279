// For how many updates margins are meant to last.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ecods {

// Wide fat boxes make candidates that are tested for nothing, in proportion to their width; narrow ones are escaped
// from sooner, in inverse proportion. The sum is least where both cost the same, which is off by the root of their
// ratio. Work is compared from one search of everything to the next, since most of it comes then. It is counted in
// tests.
class Lookahead {
  public:
    double updates() const noexcept { return updates_; }

    // Of an update: candidates that were tested and had not overlapped, and tests that looked for candidates of boxes
    // that escaped, in trees. Those for boxes that jumped do not count: no margin would have spared them.
    void note(std::size_t wasted, std::uint64_t searched) noexcept {
        // A test in trees costs more than one of a candidate, since it comes with linking and a new fat box.
        constexpr double search_cost = 2;
        wasted_ += static_cast<double>(wasted);
        searched_ += search_cost * static_cast<double>(searched);
    }
    // That a search for everything made, many at a time. It sorts boxes and gives them margins beside.
    void note_everything(std::uint64_t tests) noexcept { searched_ += static_cast<double>(tests); }
    void note_update() noexcept { ++updates_since_adapted_; }

    // Whether so much work was noted of so many boxes that there is something to learn.
    bool is_due(std::size_t boxes) const noexcept { return wasted_ + searched_ > 512 * static_cast<double>(boxes); }

    void adapt() noexcept {
        constexpr std::size_t updates_min = 2;  // fewer are no motion to learn from
        if (updates_since_adapted_ >= updates_min) {
            updates_ *= std::clamp(std::sqrt((searched_ + 1) / (wasted_ + 1)), 0.5, 2.0);
            updates_ = std::clamp(updates_, least, limit_);
        }
        wasted_ = searched_ = 0;
    }

    // Before anything is known of a motion: what is tested for nothing grows with the pairs there are, and what a
    // search costs does not, so that the best lookahead falls with the root of the pairs a box has. Measured, of boxes
    // of like sizes.
    static double guess(std::size_t pairs, std::size_t boxes) noexcept {
        constexpr double for_one_pair = 50;
        const double pairs_per_box = static_cast<double>(pairs + 1) / static_cast<double>(boxes + 1);
        return std::clamp(for_one_pair / std::sqrt(pairs_per_box), least, most);
    }

    // Of a motion that has just begun, or changed, and of which fast boxes have margins for so many updates at most.
    void start(double updates, double limit = most) noexcept {
        this->limit(limit);
        updates_ = std::clamp(updates, least, limit_);
        wasted_ = searched_ = 0;
    }
    void limit(double updates) noexcept { limit_ = std::clamp(updates, least, most); }

    // The updates that were noted since all boxes got other margins.
    std::size_t restart() noexcept { return std::exchange(updates_since_adapted_, 0); }

  private:
    static constexpr double least = 2, most = 64;

    double updates_ = 24;
    double limit_ = most;
    double wasted_ = 0, searched_ = 0;
    std::size_t updates_since_adapted_ = 0;
};

}  // namespace ecods
