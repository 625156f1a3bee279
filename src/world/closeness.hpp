// Keeps the pairs of bodies that are within the clearance: enlarged boxes find them, and their verdicts are kept like
// collisions.
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

// Compares by bits, as the processor may take two subnormal numbers for zero.
inline bool is_same_clearance(const std::optional<double>& a, const std::optional<double>& b) noexcept {
    return a.has_value() == b.has_value() && (!a || key_of(*a) == key_of(*b));
}

// Closeness has a broad phase of its own, made by the first update with a clearance. It finds the pairs whose boxes
// overlap when each is enlarged by half the clearance; their verdicts are kept like those of collisions.
//
// An update calls follow(), answers each test of pairs() that has no answer, and calls prepare() and commit(). If one
// of these steps throws, the lists stay as they were.
class Closeness {
  public:
    explicit Closeness(BroadPhaseKind kind) : kind_(kind) {}

    // Sets the clearance from the next update on; empty: no pair is close. It must be finite and not negative.
    void set(std::optional<double> clearance) noexcept { wanted_ = clearance; }
    std::optional<double> wanted() const noexcept { return wanted_; }

    // Returns the question that every test must answer; nothing without a clearance.
    std::optional<Question> question() const noexcept {
        return wanted_ ? std::optional(Question::within) : std::nullopt;
    }

    // Returns the clearance with which the lists were made.
    std::optional<double> listed() const noexcept { return listed_; }

    // True if an update before which no body changed has nothing to do.
    bool is_up_to_date() const noexcept { return is_same_clearance(wanted_, listed_); }

    // Finds the pairs to be tested. A pair that `collisions` found to collide in the same update is close and needs no
    // test. `boxes` has the boxes of the bodies, not enlarged.
    void follow(const OverlapTracker& boxes, const Bodies& bodies, Changes& changes, const PairVerdicts& collisions);
    PairVerdicts& pairs() noexcept { return pairs_; }
    const PairVerdicts& pairs() const noexcept { return pairs_; }
    void prepare();
    void commit() noexcept;
    void idle() noexcept;  // in place of these steps, for an update before which nothing changed

    ClearanceStatistics statistics() const;
    std::size_t memory_bytes() const noexcept;

    // Returns the enlarged boxes. The last update must have been made with a clearance.
    const OverlapTracker& tracker() const { return *tracker_; }

    // Throws BrokenInvariant unless the enlarged boxes fit the bodies. Call it after an update that succeeded.
    void validate(const Bodies& bodies, const OverlapTracker& boxes) const;

  private:
    void follow_boxes(const OverlapTracker& boxes, const Bodies& bodies, const Changes& changes);
    void follow_box(ProxyIndex proxy, const OverlapTracker& boxes, const Slot& slot);
    void take_collisions(const PairVerdicts& collisions);
    void validate_box(const Aabb& box, const Aabb& reaching) const;

    BroadPhaseKind kind_;
    std::optional<double> wanted_, listed_;
    std::optional<double> reached_;           // clearance of all boxes in tracker_; empty while they change
    std::optional<OverlapTracker> tracker_;   // empty without a clearance
    std::vector<std::uint16_t> generations_;  // by proxy: generation of the body whose box is in tracker_
    PairVerdicts pairs_;
    std::size_t test_count_ = 0;      // pairs that the current update must test
    ClearanceStatistics statistics_;  // sums alone; statistics() fills in the rest
};

}  // namespace ecods
