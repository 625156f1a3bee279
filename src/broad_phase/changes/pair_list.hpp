// Keeps the pairs that overlap, as a sorted list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// The list is brought up to date lazily: an update only leaves its events, which are applied when the list is read.
class PairList final : public PairKeeper {
  public:
    // `events` receives the events of each update. It may change only between begin_update() and the end of that
    // update, and is then ascending, each event once.
    explicit PairList(const PairEvents& events) : events_(events) {}

    // Logs the events of the last update, before the next one clears them. If memory runs out, in this function and in
    // those below, the list is unchanged.
    void begin_update();

    // Ends an update that succeeded, or with drop_update() one that failed, which left no events.
    void end_update() noexcept;
    void drop_update() noexcept;

    // Functions of PairKeeper, during an update. After compare(), end_update() replaces the list by the pairs found.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

    // Returns the pairs, ascending. Cost: one pass if there were events since the last call, otherwise constant.
    const ProxyPairs& sorted();

    std::size_t bytes() const noexcept;

  private:
    struct Change {
        ProxyPair pair;
        std::uint32_t order;  // even: ended; odd: began
    };

    void log_events();
    void apply_log();
    void patch(const ProxyPairs& gone, const ProxyPairs& come);
    void patch_in_place(const ProxyPairs& gone, const ProxyPairs& come);
    void make_patched(const ProxyPairs& gone, const ProxyPairs& come);

    const PairEvents& events_;
    ProxyPairs list_;
    ProxyPairs spare_;         // the next list_ while it is made, so that a failure leaves list_ unchanged
    std::vector<Change> log_;  // events that list_ lacks, from updates before the last
    std::uint32_t order_ = 0;
    bool is_pending_ = false;   // list_ lacks the events of the last update, too
    bool is_replaced_ = false;  // during an update: spare_ holds the new list
};

}  // namespace ecods
