// A broad phase finds the boxes that overlap, and the boxes that a box, a segment or a ball meets. It never sees a
// triangle. (FCL, Coal: BroadPhaseCollisionManager; Parry: BroadPhaseBvh; Box3D: b3DynamicTree and its pairs.)
//
// All broad phases give the same pairs for the same boxes, always: those whose closed boxes share a point. They differ
// in cost. A caller normally picks one in WorldOptions and never touches this interface; it is public so that it can be
// tested, timed and used alone.
//
// Example: verify/examples/how_do_i, find_boxes().
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods {

// Names one box in one broad phase, by the number that its owner chose. Numbers are array indices: keep them dense.
using ProxyIndex = std::uint32_t;

// Two proxies, a < b.
struct ProxyPair {
    ProxyIndex a = 0;
    ProxyIndex b = 0;

    friend constexpr auto operator<=>(const ProxyPair&, const ProxyPair&) = default;
};

enum class BroadPhaseKind : std::uint8_t {
    // Tests every box against every other: the model that the others are checked against. n^2 / 2 tests an update in
    // which anything moved.
    brute_force,
    // Keeps three sorted lists of box ends, re-sorted by insertion, and tracks pairs as ends swap: the algorithm of the
    // ECoDS report. Work per update: one step for each pair of ends that changed order, plus one pass over the lists
    // when boxes came or went, or when a large part moved. Excellent while little moves and boxes are few; when boxes
    // jump, so that sorting from scratch costs less than the steps, it does that. Memory: about 260 bytes a box and 8
    // to 16 a pair for the list of pairs, which a World has no use for.
    sweep_and_prune,

    // Serves large, dynamic scenes: a dynamic tree of enlarged boxes. Each box is given a margin to move in; pairs that
    // overlap with their margins, and of which one is awake, are candidates, which are kept from update to update and
    // tested at each one. A box that moves is awake until it has been at rest for some updates. One that left its
    // margin, or awoke, is looked up in trees over all boxes, one for each class of sizes; when many did at once,
    // everything is looked up. How wide margins are is adapted from counts, and those of boxes that all move together
    // go along with them. Where boxes leave any margin at once, or come and go in numbers, none has one, and each
    // update searches for all pairs from scratch: counts decide, which are looked at again some updates later. Work per
    // update: a few tests for each box that moved, or did so lately; or that of a search from scratch, a sort and a
    // sweep in the cells of a grid, whatever boxes do. Memory: about 240 bytes a box at rest, and 8 to 16 a pair, as
    // above; while boxes move, about 230 more for searches from scratch, and 8 a candidate, of which there are some
    // more than pairs.
    kept_candidates,

    // Uses sweep_and_prune while boxes are few, otherwise kept_candidates. Only the number of boxes decides, at each
    // update and before the first one; the choice affects cost alone.
    automatic,
};

// Counts the work of a broad phase since it was made.
struct BroadPhaseCounts {
    std::uint64_t updates = 0;    // calls of update()
    std::uint64_t moved = 0;      // boxes that were new, or were given another box, since the update before; summed
    std::uint64_t box_tests = 0;  // overlap tests of two boxes, in whole or on the two other axes; of candidates: below

    // sweep_and_prune counts these.
    std::uint64_t swaps = 0;  // ends that passed each other in the sorted lists

    // kept_candidates counts these.
    std::uint64_t candidates_filtered = 0;  // tests of pairs that were candidates already
    std::uint64_t escaped = 0;              // boxes that left their margin
    std::uint64_t rebuilds = 0;             // updates at which everything was looked up

    // automatic counts this.
    std::uint64_t switches = 0;
};

// Counts the work of the questions about the boxes of a broad phase since it was made.
struct FindCounts {
    std::uint64_t calls = 0;
    std::uint64_t box_tests = 0;  // of a box, segment or ball against a box, or against what bounds some boxes
    std::uint64_t refreshed = 0;  // boxes that came or changed, and that the trees were brought up to date for
};

class ECODS_API BroadPhase {
  public:
    virtual ~BroadPhase() = default;

    virtual BroadPhaseKind kind() const noexcept = 0;

    // Adds a box. `proxy` must not be present and must be below 2^31. Takes effect at once for box(), and for pairs()
    // at update(), as do move and remove. Boxes must be free of NaN with min <= max; the owner checks. A `proxy` that
    // is not as it must be throws Error, and nothing has changed.
    virtual void add(ProxyIndex proxy, const Aabb& box) = 0;
    virtual void move(ProxyIndex proxy, const Aabb& box) = 0;  // `proxy` must be present
    virtual void remove(ProxyIndex proxy) = 0;                 // `proxy` must be present

    // Moves many boxes, in their order: the last box of a proxy that is named more than once holds. All are moved or
    // none: throws Error where one is not present, or where there is not a box for each. Cost: less than that of a call
    // for each.
    virtual void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes) = 0;

    virtual Aabb box(ProxyIndex proxy) const = 0;   // `proxy` must be present
    virtual std::size_t size() const noexcept = 0;  // boxes present

    // Reserves memory for `count` boxes of numbers below that, so that adding them allocates little.
    virtual void reserve(std::size_t count) = 0;

    // Makes `pairs()` the pairs of boxes that overlap now. An update before which nothing changed costs a constant.
    // Out of memory (std::bad_alloc), pairs() stays what it was, began() and ended() are empty, and the next update
    // finds all that changed since the last one that succeeded.
    virtual void update() = 0;

    // Returns the pairs as of the last update, ascending. Valid until the next call that is not const. The list is
    // brought up to date when it is asked for: one pass over it if pairs came or went since it was asked for last,
    // otherwise nothing.
    virtual const std::vector<ProxyPair>& pairs() = 0;

    // Return the pairs that came and went with the last update, ascending; a removed proxy's pairs count as gone, also
    // when its number was used again before the update and the new box makes the same pair: it is then in both.
    virtual const std::vector<ProxyPair>& began() const noexcept = 0;
    virtual const std::vector<ProxyPair>& ended() const noexcept = 0;

    // Return the boxes that share a point with this box, segment or ball, ascending: boxes as they are now, whether
    // update() has been called since or not. Decided exactly; all broad phases give the same. Throws InvalidArgument.
    // Safe from many threads, as long as no call that is not const runs.
    //
    // Cost: brute_force and sweep_and_prune, and the others while they have few boxes, test all boxes. kept_candidates
    // and automatic make trees at the first such call (n log n, and about 150 bytes a box); from then on a call costs a
    // few tests for each box that it finds or that is close by, and for each level of the trees, and one for each box
    // that came or changed since the call before.
    virtual std::vector<ProxyIndex> find(const Aabb& box) const = 0;
    virtual std::vector<ProxyIndex> find(const Segment& segment) const = 0;
    virtual std::vector<ProxyIndex> find(const Ball& ball) const = 0;

    // Calls `visit` with boxes in ascending order of a lower bound of their distance from this one, up to `limit`.
    // `visit` returns a new limit, which counts if it is smaller. All boxes within the limit are visited; some beyond
    // it may be. Boxes as they are now. Throws InvalidArgument for a bad box or limit; what `visit` throws passes
    // through. Safe from many threads, as find().
    //
    // Cost: brute_force, and the others while they have few boxes, test all boxes. Otherwise in trees, which are made
    // as for find(): some tests for each box that is visited, and for each level of the trees.
    virtual void visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const = 0;

    // Does the same for pairs of boxes, each once; where all are tested, in the order of the pairs. Cost: brute_force,
    // and the others while they have few boxes, test all pairs. Otherwise some tests for each two boxes that are within
    // the limit, and for each two blocks of neighbours that are.
    virtual void visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const = 0;

    // Calls `visit` with each box that this segment, ray or box, which is translated by time times `motion`, is not
    // proven to miss, in the order of lower bounds of the first parameter or time at which it meets them, as far as
    // these are at most the limit: 1 of a segment, the largest parameter of a ray. Otherwise as visit_near(). Throws
    // InvalidArgument.
    virtual void visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const = 0;
    virtual void visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const = 0;
    virtual void visit_along(const Aabb& box, const Vec3& motion, double limit,
                             const std::function<double(ProxyIndex)>& visit) const = 0;

    // Returns the work of find() and of all these.
    virtual FindCounts find_counts() const noexcept = 0;

    virtual const BroadPhaseCounts& counts() const noexcept = 0;

    // Returns the memory held, working memory included. Cost: a constant for brute_force and sweep_and_prune, otherwise
    // proportional to the depth of the trees.
    virtual std::size_t bytes() const noexcept = 0;

    // Checks every invariant of the structure and throws BrokenInvariant. May cost n^2. Call it after update().
    virtual void check_invariants() const = 0;
};

ECODS_API std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind);

}  // namespace ecods
