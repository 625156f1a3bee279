// Finds the pairs of bodies that are within the clearance. Enlarged boxes give the candidate pairs; the verdicts of
// these pairs are cached, as the verdicts of collisions are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/double_key.hpp"
#include "broad_phase/overlap_tracker.hpp"
#include "ecods/world.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/pair_verdicts.hpp"

namespace ecods {

// Returns true if both clearances are absent, or both have equal values. Compares the bits, because a processor that
// flushes subnormal numbers to zero takes any two subnormal numbers for equal.
inline bool is_same_clearance(const std::optional<double>& a, const std::optional<double>& b) noexcept {
    return a.has_value() == b.has_value() && (!a || key_of(*a) == key_of(*b));
}

// Closeness has a broad phase of its own, which the first update with a clearance creates. Each body's box is enlarged
// there by half the clearance, and each pair of boxes that overlap has a cached verdict.
//
// An update calls follow(), answers each test of pairs() whose answer is `none`, and then calls prepare() and commit().
// If one of these steps throws, the lists stay as they were.
class Closeness {
  public:
    explicit Closeness(BroadPhaseKind kind) : kind_(kind) {}

    // Sets the clearance for the next updates. With nullopt no pair is close. The clearance must be finite and not
    // negative.
    void set(std::optional<double> clearance) noexcept { wanted_ = clearance; }
    std::optional<double> wanted() const noexcept { return wanted_; }

    // Returns the question that every two-body test must be able to answer; nullopt if no clearance is set.
    std::optional<Question> question() const noexcept {
        return wanted_ ? std::optional(Question::within) : std::nullopt;
    }

    // Returns the clearance of the last update, with which the lists were made.
    std::optional<double> listed() const noexcept { return listed_; }

    // Returns true if the clearance is that of the last update. If no body has changed either, an update has nothing to
    // do.
    bool is_up_to_date() const noexcept { return is_same_clearance(wanted_, listed_); }

    // Finds the pairs to be tested for being within the clearance. Pairs that `collisions` has found to collide in the
    // same update are close, so they get their answer without a test. `boxes` has the boxes of the bodies, not
    // enlarged.
    void follow(const OverlapTracker& boxes, const Bodies& bodies, Changes& changes, const PairVerdicts& collisions);
    PairVerdicts& pairs() noexcept { return pairs_; }
    const PairVerdicts& pairs() const noexcept { return pairs_; }
    void prepare();
    void commit() noexcept;
    void idle() noexcept;  // replaces the steps of an update if nothing has changed

    ClearanceStatistics statistics() const;
    std::size_t memory_bytes() const noexcept;

    // Returns the tracker of the enlarged boxes. Call only if the last update had a clearance.
    const OverlapTracker& tracker() const { return *tracker_; }

    // Throws BrokenInvariant if an enlarged box does not fit its body. Call only after an update that succeeded.
    void validate(const Bodies& bodies, const OverlapTracker& boxes) const;

  private:
    void follow_boxes(const OverlapTracker& boxes, const Bodies& bodies, const Changes& changes);
    void follow_box(ProxyIndex proxy, const OverlapTracker& boxes, const Slot& slot);
    void take_collisions(const PairVerdicts& collisions);
    void validate_box(const Aabb& box, const Aabb& reaching) const;

    BroadPhaseKind kind_;
    std::optional<double> wanted_, listed_;
    std::optional<double> reached_;           // clearance of tracker_'s boxes; empty while they are being changed
    std::optional<OverlapTracker> tracker_;   // empty until an update has a clearance
    std::vector<std::uint16_t> generations_;  // by proxy: generation of the body whose enlarged box tracker_ has
    PairVerdicts pairs_;
    std::size_t test_count_ = 0;      // pairs that the current update must test
    ClearanceStatistics statistics_;  // running totals only; statistics() fills in the other members
};

}  // namespace ecods
