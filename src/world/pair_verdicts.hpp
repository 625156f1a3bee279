// Pairs of bodies whose boxes overlap, each with the exact answer to one question, and the lists that follow from them:
// of the world's own boxes, whether two bodies collide; of boxes that reach further, whether they are close.
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

// An update is follow(), collect(), an answer for each test that has none, prepare() and commit(). Where one of them
// throws, the lists stay as they were, and what was followed is known to the next update.
class PairVerdicts {
  public:
    void reserve_bodies(std::size_t count) { verdicts_.reserve(0, count); }

    // Updates the tracker, and makes the pairs here those whose boxes overlap. What this and collect() looked at is
    // added to `visited_pairs`.
    void follow(OverlapTracker& tracker, const Bodies& bodies, std::uint64_t& visited_pairs);

    // Makes tests() those of every pair of which a body changed, or that was switched on or off; or, where all verdicts
    // are void, of every pair. Their answers are `none`, or `filtered_out`.
    void collect(const Bodies& bodies, Changes& changes, bool all_are_void, std::uint64_t& visited_pairs);
    std::span<const VerdictIndex> tests() const noexcept { return tests_; }
    Answer& answer(VerdictIndex index) noexcept { return verdicts_.answer(index); }

    // Makes the next lists of events, of the answers.
    void prepare();

    // Takes the answers over. Returns the number of tests that had not been filtered out.
    std::size_t commit() noexcept;

    // In place of all that, for an update before which nothing changed.
    void clear_events() noexcept;

    // In place of all that: what was listed has ended, and no pair is here any more.
    void end_all() noexcept;

    const VerdictCache& verdicts() const noexcept { return verdicts_; }
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_.witness(index); }

    const BodyPairs& overlapping();                                   // made when it is asked for
    const BodyPairs& positive() const noexcept { return positive_; }  // of which the answer is yes
    const BodyPairs& began() const noexcept { return began_; }
    const BodyPairs& ended() const noexcept { return ended_; }

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant unless the lists are those of the verdicts.
    void validate() const;

  private:
    void take_over(const PairEvents& events, const Bodies& bodies);
    void collect_pair(VerdictIndex index, const Bodies& bodies, bool is_void);
    void list_overlapping(BodyPairs& list) const;

    VerdictCache verdicts_;
    std::vector<VerdictIndex> tests_;
    BodyPairs lost_;  // positive pairs that are no candidates any more, of updates that did not succeed yet; unordered
    BodyPairs next_began_, next_ended_;  // of the update under way

    BodyPairs overlapping_;
    bool overlapping_is_stale_ = false;
    BodyPairs positive_, began_, ended_;
};

}  // namespace ecods
