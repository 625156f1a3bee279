// The pairs of bodies that are within the clearance: of boxes that reach further, kept as collisions are.
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

// By bits, as two subnormal numbers may be taken for zero.
inline bool is_same_clearance(const std::optional<double>& a, const std::optional<double>& b) noexcept {
    return a.has_value() == b.has_value() && (!a || key_of(*a) == key_of(*b));
}

// A broad phase of its own, made by the first update with a clearance, finds the pairs whose boxes overlap when each is
// enlarged by half the clearance; their verdicts are kept as those of collisions. An update is follow(), an answer for
// each test of pairs() that has none, prepare() and commit(): where one of them throws, the lists stay as they were.
class Closeness {
  public:
    explicit Closeness(BroadPhaseKind kind) : kind_(kind) {}

    // From the next update on; nothing: without clearance. Finite, not negative.
    void set(std::optional<double> clearance) noexcept { wanted_ = clearance; }
    std::optional<double> wanted() const noexcept { return wanted_; }

    // What every test must answer.
    std::optional<Question> question() const noexcept {
        return wanted_ ? std::optional(Question::within) : std::nullopt;
    }

    // The clearance of the lists.
    std::optional<double> listed() const noexcept { return listed_; }

    // Whether an update before which no body changed has nothing to do.
    bool is_up_to_date() const noexcept { return is_same_clearance(wanted_, listed_); }

    // Finds the pairs to be tested. Those that `collisions` found to collide, in the same update, are close, and need
    // no test. `boxes` are those of the bodies.
    void follow(const OverlapTracker& boxes, const Bodies& bodies, Changes& changes, const PairVerdicts& collisions);
    PairVerdicts& pairs() noexcept { return pairs_; }
    const PairVerdicts& pairs() const noexcept { return pairs_; }
    void prepare();
    void commit() noexcept;
    void idle() noexcept;  // in place of all that, for an update before which nothing changed

    ClearanceStatistics statistics() const;
    std::size_t memory_bytes() const noexcept;

    // The boxes that reach further. There must be a clearance, and an update after it.
    const OverlapTracker& tracker() const { return *tracker_; }

    // Throws BrokenInvariant unless the boxes are those of the bodies. After an update that succeeded.
    void validate(const Bodies& bodies, const OverlapTracker& boxes) const;

  private:
    void follow_boxes(const OverlapTracker& boxes, const Bodies& bodies, const Changes& changes);
    void follow_box(ProxyIndex proxy, const OverlapTracker& boxes, const Slot& slot);
    void take_collisions(const PairVerdicts& collisions);
    void validate_box(const Aabb& box, const Aabb& reaching) const;

    BroadPhaseKind kind_;
    std::optional<double> wanted_, listed_;
    std::optional<double> reached_;           // the clearance of all boxes in tracker_; nothing while they are changing
    std::optional<OverlapTracker> tracker_;   // none while there is no clearance
    std::vector<std::uint16_t> generations_;  // by proxy: of the bodies whose boxes are in tracker_
    PairVerdicts pairs_;
    std::size_t test_count_ = 0;      // of the update under way: pairs that need a test
    ClearanceStatistics statistics_;  // sums; the rest is filled in on request
};

}  // namespace ecods
