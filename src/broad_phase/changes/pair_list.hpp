// The pairs there are, and how they change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

using ProxyPairs = std::vector<ProxyPair>;

inline ProxyPair ordered_pair(ProxyIndex a, ProxyIndex b) noexcept {
    return a < b ? ProxyPair{a, b} : ProxyPair{b, a};
}

// One number that orders as the pair does.
constexpr std::uint64_t rank_of(const ProxyPair& pair) noexcept {
    return std::uint64_t{pair.a} << 32 | pair.b;
}

// Sorts ascending.
void sort_pairs(ProxyPairs& pairs);

// Sorts, and leaves each pair once.
void normalise(ProxyPairs& pairs);

// A sorted list of pairs that is brought up to date when it is read. An update tells what began and ended; nothing
// else is done until somebody asks.
class PairList {
  public:
    // Forgets the events of the last update, in began and ended; their effect is kept. Out of memory, here and in all
    // below, the list is what it was.
    void begin_update();

    // Where an update puts the pairs that come and go, in any order, each once. A pair may be in both: then it ended
    // and another of the same numbers began.
    ProxyPairs began, ended;

    // Sorts the events. Cost: sorting them; and now and then one pass over the list, at most a constant number of
    // steps for each event since the last pass.
    void end_update();

    // In place of end_update, for an update that failed: there were no events.
    void drop_update() noexcept;

    // For those that have found all pairs anew, during an update: `found`, ascending, is what is here now. `ended`
    // holds what ended for another reason, and does so still; the differences are added to both lists of events. What
    // is left in `found` is memory to be used again.
    void replace(ProxyPairs& found);

    // The pairs, ascending. Cost: one pass if there were events since it was asked last, else nothing.
    const ProxyPairs& sorted();

    std::size_t bytes() const noexcept;

  private:
    struct Change {
        ProxyPair pair;
        std::uint32_t order;  // even: ended; odd: began
    };

    bool has_pending_events() const noexcept { return is_pending_ && !(began.empty() && ended.empty()); }
    void log_events();
    void apply_log();
    void patch(const ProxyPairs& gone, const ProxyPairs& come);
    void make_patched(const ProxyPairs& gone, const ProxyPairs& come);

    ProxyPairs list_;
    ProxyPairs spare_;         // where the next list_ is made, so that making it may fail
    std::vector<Change> log_;  // events that list_ lacks, of updates before the last
    std::uint32_t order_ = 0;
    bool is_pending_ = false;   // list_ lacks began and ended, too
    bool is_replaced_ = false;  // during an update: spare_ has what it found
};

}  // namespace ecods
