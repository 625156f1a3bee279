// The pairs there are, as a sorted list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"

namespace ecods {

// Is brought up to date when it is read: an update leaves its events, and nothing else is done until somebody asks.
class PairList final : public PairKeeper {
  public:
    // The events of updates appear in `events`, which are not changed but between begin_update() and the end of that
    // update, and are then ascending and each once.
    explicit PairList(const PairEvents& events) : events_(events) {}

    // Before an update clears the events: their effect is kept. Out of memory, here and in all below, the list is what
    // it was.
    void begin_update();

    // After an update: either that, or the other for one that failed, of which there are no events.
    void end_update() noexcept;
    void drop_update() noexcept;

    // During an update. Where it compares, end_update() makes what was found the list.
    void append_removed(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& ended) override;
    void compare(const ProxyTable& table, const ProxyChanges& changes, ProxyPairs& found, PairEvents& events) override;

    // The pairs, ascending. Cost: one pass if there were events since it was asked last, otherwise nothing.
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
    ProxyPairs spare_;         // where the next list_ is made, so that making it may fail
    std::vector<Change> log_;  // events that list_ lacks, of updates before the last
    std::uint32_t order_ = 0;
    bool is_pending_ = false;   // list_ lacks the events of the last update, too
    bool is_replaced_ = false;  // during an update: spare_ has what it found
};

}  // namespace ecods
