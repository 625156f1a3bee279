// Stores the pairs of bodies whose boxes overlap, each with its exact answer to one question, and the lists that follow
// from the answers. For the bodies' own boxes the question is whether the two bodies collide; for enlarged boxes,
// whether they are close.
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

// An update calls follow() and collect(), sets the answer of each test whose answer is `none`, and then calls prepare()
// and commit(). If one of these steps throws, the lists stay as they were; the stored pairs stay as follow() left them,
// and the next update continues from them.
class PairVerdicts {
  public:
    void reserve_bodies(std::size_t count) { verdicts_.reserve(0, count); }

    // Updates the tracker, and then adds and removes pairs until the stored pairs are exactly the pairs whose boxes
    // overlap. Adds to `visited_pairs` the number of pairs that it processes; so does collect().
    void follow(OverlapTracker& tracker, const Bodies& bodies, std::uint64_t& visited_pairs);

    // Sets tests() to the pairs that have a changed body or were switched on or off; to all pairs if `all_are_void`.
    // Leaves out pairs that were filtered out and still are, and pairs whose verdict still holds. Sets the answer of
    // each test to `filtered_out`, or to `none` if the pair must be tested.
    void collect(const Bodies& bodies, Changes& changes, bool all_are_void, std::uint64_t& visited_pairs);
    std::span<const VerdictIndex> tests() const noexcept { return tests_; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_.answer(index); }

    // Computes the lists of events that commit() will publish, from the answers.
    void prepare();

    // Makes the answers and the prepared lists the current ones. Returns the number of tests that were not filtered
    // out.
    std::size_t commit() noexcept;

    // Clears the lists of events. Replaces the steps from follow() to commit() in an update before which nothing
    // changed.
    void clear_events() noexcept;

    // Removes all pairs, and reports that every positive pair ended. Replaces the steps from follow() to commit() in an
    // update that removes all pairs.
    void end_all() noexcept;

    const VerdictCache& verdicts() const noexcept { return verdicts_; }
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_.witness(index); }

    const BodyPairs& overlapping();                                   // computed by this call if it is stale
    const BodyPairs& positive() const noexcept { return positive_; }  // pairs whose answer is yes
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
    BodyPairs lost_;  // positive pairs whose boxes parted since the last successful update; unordered
    BodyPairs next_began_, next_ended_;  // lists that prepare() computes

    BodyPairs overlapping_;
    bool overlapping_is_stale_ = false;
    BodyPairs positive_, began_, ended_;
};

}  // namespace ecods
