// Keeps the pairs that overlap, as a sorted list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// A PairList is updated lazily: an update only logs its events, and sorted() applies the logged events when the list is
// read.
class PairList final : public PairKeeper {
  public:
    // Refers to `events`, where the caller puts the events of each update; `events` must outlive the list. The events
    // may change only between begin_update() and the end of that update. At this end both lists must be ascending, each
    // event once.
    explicit PairList(const PairEvents& events) : events_(events) {}

    // Logs the events of the last update unless the list has these events. Call begin_update() before the next update
    // clears the events. If memory runs out in this function or in one below, the list is unchanged.
    void begin_update();

    // End an update: end_update() if it succeeded, drop_update() if it failed. A failed update must leave no events.
    void end_update() noexcept;
    void drop_update() noexcept;

    // Implement PairKeeper; call them only during an update. After compare(), end_update() replaces the list by
    // `found`.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

    // Returns the pairs, ascending. Cost: one pass if there were events since the last call, otherwise constant.
    const ProxyPairs& sorted();

    std::size_t bytes() const noexcept;

  private:
    struct Change {
        ProxyPair pair;
        std::uint32_t order;  // ascends with time; even: the pair ended, odd: it began
    };

    void log_events();
    void apply_log();
    void patch(const ProxyPairs& gone, const ProxyPairs& come);
    void patch_in_place(const ProxyPairs& gone, const ProxyPairs& come);
    void make_patched(const ProxyPairs& gone, const ProxyPairs& come);

    const PairEvents& events_;
    ProxyPairs list_;
    ProxyPairs spare_;         // the next list_ while it is computed, so that a failure leaves list_ unchanged
    std::vector<Change> log_;  // events of updates before the last one that list_ lacks
    std::uint32_t order_ = 0;
    bool is_pending_ = false;   // true if list_ lacks the events of the last update
    bool is_replaced_ = false;  // true after compare() until the update ends: spare_ holds the next list_
};

}  // namespace ecods
