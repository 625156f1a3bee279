// Keeps the pairs of bodies whose boxes overlap, each with the exact answer to one question, and the lists that follow
// from the answers. With the bodies' own boxes the question is whether two bodies collide; with enlarged boxes, whether
// they are close.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/overlap_tracker.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/sorted_pairs.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// An update calls follow() and collect(), answers each test that has no answer, and calls prepare() and commit(). If
// one of these steps throws, the lists stay as they were, and the next update goes on from the pairs that were
// followed.
class PairVerdicts {
  public:
    void reserve_bodies(std::size_t count) { verdicts_.reserve(0, count); }

    // Updates the tracker, and makes the pairs here those whose boxes overlap. Adds the number of pairs that it looks
    // at to `visited_pairs`, as collect() does.
    void follow(OverlapTracker& tracker, const Bodies& bodies, std::uint64_t& visited_pairs);

    // Makes tests() the pairs of which a body changed, or that were switched on or off; if all verdicts are void, all
    // pairs. Leaves out each pair whose verdict still holds. Sets the answers of tests() to `none` or `filtered_out`.
    void collect(const Bodies& bodies, Changes& changes, bool all_are_void, std::uint64_t& visited_pairs);
    std::span<const VerdictIndex> tests() const noexcept { return tests_; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_.answer(index); }

    // Makes the next lists of events from the answers.
    void prepare();

    // Makes the answers and the next lists the current ones. Returns the number of tests that were not filtered out.
    std::size_t commit() noexcept;

    // Takes the place of these steps in an update before which nothing changed.
    void clear_events() noexcept;

    // Takes the place of these steps: all listed pairs end, and all pairs are removed.
    void end_all() noexcept;

    const VerdictCache& verdicts() const noexcept { return verdicts_; }
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_.witness(index); }

    const BodyPairs& overlapping();                                   // made on demand
    const BodyPairs& positive() const noexcept { return positive_; }  // pairs with the answer yes
    const BodyPairs& began() const noexcept { return began_; }
    const BodyPairs& ended() const noexcept { return ended_; }

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant unless the lists agree with the verdicts.
    void validate() const;

  private:
    void take_over(const PairEvents& events, const Bodies& bodies);
    void collect_pair(VerdictIndex index, const Bodies& bodies, bool is_void);
    void list_overlapping(BodyPairs& list) const;

    VerdictCache verdicts_;
    std::vector<VerdictIndex> tests_;
    BodyPairs lost_;  // positive pairs that are candidates no more, since the last update that succeeded; unordered
    BodyPairs next_began_, next_ended_;  // of the current update

    BodyPairs overlapping_;
    bool overlapping_is_stale_ = false;
    BodyPairs positive_, began_, ended_;
};

}  // namespace ecods
