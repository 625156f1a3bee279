// Which boxes overlap. Boxes only: a broad phase never sees a triangle.
//
// All broad phases give the same pairs for the same boxes, always: those whose closed boxes share a point. They differ
// in cost. A caller normally picks one in WorldOptions and never touches this interface; it is public so that it can be
// tested, timed and used alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/aabb.hpp"

namespace ecods {

// Names one box in one broad phase, by the number that its owner chose. Numbers are used as array indices: keep
// them dense.
using ProxyIndex = std::uint32_t;

// Two proxies, a < b.
struct ProxyPair {
    ProxyIndex a = 0;
    ProxyIndex b = 0;

    friend constexpr auto operator<=>(const ProxyPair&, const ProxyPair&) = default;
};

enum class BroadPhaseKind : std::uint8_t {
    // Every box against every other. The model that the others are checked against. n^2 / 2 tests an update in
    // which anything moved.
    brute_force,
    // The ECoDS report's algorithm: three sorted lists of box ends, re-sorted by insertion, pairs tracked as ends
    // swap. Work per update: one step for each pair of ends that changed order, plus one pass over the lists when boxes
    // came or went, or when a large part moved. Excellent while little moves; when boxes jump, so that sorting
    // from scratch costs less than the steps, it does that.
    sweep_and_prune,
};

// What a broad phase did since it was made, as counts.
struct BroadPhaseCounts {
    std::uint64_t updates = 0;    // calls of update()
    std::uint64_t moved = 0;      // boxes that at an update were new or not the same as at the one before, summed
    std::uint64_t box_tests = 0;  // overlap tests of two boxes, in whole or on the two other axes
    std::uint64_t swaps = 0;      // ends that passed each other in the sorted lists
};

class BroadPhase {
  public:
    virtual ~BroadPhase() = default;

    virtual BroadPhaseKind kind() const noexcept = 0;

    // Adds a box. `proxy` must not be present and must be below 2^31. Takes effect at once for box(), and for pairs()
    // at update(), as do move and remove. Boxes must be free of NaN with min <= max; the owner checks. A `proxy` that
    // is not as it must be throws Error, and nothing has changed.
    virtual void add(ProxyIndex proxy, const Aabb& box) = 0;
    virtual void move(ProxyIndex proxy, const Aabb& box) = 0;  // `proxy` must be present
    virtual void remove(ProxyIndex proxy) = 0;                 // `proxy` must be present
    virtual const Aabb& box(ProxyIndex proxy) const = 0;       // `proxy` must be present
    virtual std::size_t size() const noexcept = 0;             // boxes present

    // Makes `pairs()` the pairs of boxes that overlap now. An update before which nothing changed costs a constant.
    virtual void update() = 0;

    // The pairs as of the last update, ascending. Valid until the next call that is not const.
    virtual const std::vector<ProxyPair>& pairs() const noexcept = 0;

    // The pairs that came and went with the last update, ascending; a removed proxy's pairs count as gone, also
    // when its number was used again before the update and the new box makes the same pair: it is then in both.
    virtual const std::vector<ProxyPair>& began() const noexcept = 0;
    virtual const std::vector<ProxyPair>& ended() const noexcept = 0;

    virtual const BroadPhaseCounts& counts() const noexcept = 0;

    // Checks every invariant of the structure and throws BrokenInvariant. May cost n^2. Call it after update().
    virtual void validate() const = 0;
};

std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind);

}  // namespace ecods
