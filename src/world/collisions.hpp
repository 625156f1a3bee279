// The candidate pairs of a world with their verdicts, and the lists that follow from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad_phase/changes/pair_events.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/sorted_pairs.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// An update is take_over(), collect(), an answer for each test that asks for one, and commit(). Where one of them
// throws, the lists stay as they were, and what was taken over is known to the next update.
class Collisions {
  public:
    enum class Answer : std::uint8_t { none, filtered_out, disjoint, colliding };

    // A pair that the update under way looks at.
    struct PairTest {
        VerdictIndex verdict;
        Answer answer;  // none: to be tested
    };

    void reserve_bodies(std::size_t count) { verdicts_.reserve(0, count); }

    // The pairs whose boxes overlap came and went.
    void take_over(const PairEvents& events, const Bodies& bodies);

    // Makes tests() those of every pair of which a body changed, or that was switched on or off. Adds the number of
    // pairs that were looked at to `visited_pairs`.
    void collect(const Bodies& bodies, Changes& changes, std::uint64_t& visited_pairs);
    std::span<PairTest> tests() noexcept { return tests_; }

    // Takes the answers over. Returns the number of tests that had not been filtered out.
    std::size_t commit();

    // In place of all that, for an update before which nothing changed.
    void clear_events() noexcept;

    const VerdictCache& verdicts() const noexcept { return verdicts_; }
    PairWitness& witness(VerdictIndex index) noexcept { return verdicts_.witness(index); }

    const BodyPairs& overlapping();  // made when it is asked for
    const BodyPairs& colliding() const noexcept { return colliding_; }
    const BodyPairs& began() const noexcept { return began_; }
    const BodyPairs& ended() const noexcept { return ended_; }

    std::size_t memory_bytes() const noexcept;

    // Throws BrokenInvariant unless the lists are those of the verdicts.
    void validate() const;

  private:
    void collect_pair(VerdictIndex index, const Bodies& bodies, const Changes& changes);
    void list_overlapping(BodyPairs& list) const;

    VerdictCache verdicts_;
    std::vector<PairTest> tests_;
    BodyPairs lost_;  // colliding pairs that are no candidates any more, of updates that did not succeed yet; unordered
    BodyPairs next_began_, next_ended_;  // of the update under way

    BodyPairs overlapping_;
    bool overlapping_is_stale_ = false;
    BodyPairs colliding_, began_, ended_;
};

}  // namespace ecods
