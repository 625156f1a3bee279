// A broad phase finds the pairs of boxes that overlap, and the boxes that overlap a given box, segment or ball. It
// never sees a triangle. (FCL, Coal: BroadPhaseCollisionManager; Parry: BroadPhaseBvh; Box3D: b3DynamicTree and its
// pairs.)
//
// All broad phases give the same pairs for the same boxes: the pairs whose closed boxes share a point. Broad phases
// differ in cost. Usually a caller chooses one in WorldOptions and never uses this interface, which is public so that
// it can be tested, timed and used alone.
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

// A ProxyIndex names one box of a broad phase. The owner of the broad phase chooses these numbers. They are array
// indices: keep them dense.
using ProxyIndex = std::uint32_t;

// A ProxyPair names two boxes, with a < b.
struct ProxyPair {
    ProxyIndex a = 0;
    ProxyIndex b = 0;

    friend constexpr auto operator<=>(const ProxyPair&, const ProxyPair&) = default;
};

enum class BroadPhaseKind : std::uint8_t {
    // Tests every pair of boxes for overlap. The library's own tests compare the other broad phases with this one. Each
    // update in which a box moved makes n^2 / 2 overlap tests.
    brute_force,
    // Keeps three sorted lists of box ends, sorts them again by insertion, and finds pairs as ends swap: the algorithm
    // of the ECoDS report. Work per update: one step for each pair of ends that changed order, and one pass over the
    // lists if boxes came or went or a large part moved. It is excellent if boxes are few and little moves. If boxes
    // jump, so that sorting from scratch costs less than these steps, it sorts from scratch. Memory: about 260 bytes a
    // box; 8 to 16 bytes a pair for the list of pairs, which a World does not use.
    sweep_and_prune,

    // Serves large, dynamic scenes by a dynamic tree of enlarged boxes. Each box gets a margin to move in. Two boxes
    // that overlap with their margins are candidates if one of them is awake; candidates are cached, and tested at each
    // update. A box that moves is awake until it has been at rest for some updates. A box that left its margin, or
    // awoke, is looked up in trees over all boxes, one tree for each class of sizes; if many boxes did so at once, all
    // boxes are looked up. Counts of this work adapt the widths of the margins; the margins of boxes that all move
    // together move along with them. If boxes would leave any margin at once, or if many come and go, no box has a
    // margin, and each update searches for all pairs from scratch. Counts decide this, and decide again some updates
    // later. Work per update: a few tests for each box that moves or moved lately; or that of a search from scratch,
    // which is a sort and a sweep in the cells of a grid, however boxes move. Memory: about 240 bytes a box at rest,
    // and 8 to 16 a pair, as above. While boxes move: about 230 more a box for searches from scratch, and 8 for each
    // candidate; there are a few more candidates than pairs.
    kept_candidates,

    // Uses sweep_and_prune if boxes are few, otherwise kept_candidates. Only the number of boxes decides, at each
    // update and before the first one. The choice affects cost alone.
    automatic,
};

// Counts the work of a broad phase since it was created.
struct BroadPhaseCounts {
    std::uint64_t updates = 0;    // calls of update()
    std::uint64_t moved = 0;      // boxes that were new or changed since the update before, summed over updates
    std::uint64_t box_tests = 0;  // overlap tests of two boxes, on all axes or on two, without candidates_filtered

    // The next member is counted by sweep_and_prune only.
    std::uint64_t swaps = 0;  // ends that passed each other in the sorted lists

    // The next three members are counted by kept_candidates only.
    std::uint64_t candidates_filtered = 0;  // tests of pairs that were already candidates
    std::uint64_t escaped = 0;              // boxes that left their margin
    std::uint64_t rebuilds = 0;             // updates at which all boxes were looked up

    // Counts switches from one broad phase to the other; only `automatic` switches.
    std::uint64_t switches = 0;
};

// Counts the work of questions about the boxes of a broad phase since it was created.
struct FindCounts {
    std::uint64_t calls = 0;
    std::uint64_t box_tests = 0;  // tests of a box, segment or ball against a box, or against the bounds of some boxes
    std::uint64_t refreshed = 0;  // boxes that were new or changed, and so updated in the trees
};

class ECODS_API BroadPhase {
  public:
    virtual ~BroadPhase() = default;

    virtual BroadPhaseKind kind() const noexcept = 0;

    // Adds a box. `proxy` must not be present and must be below 2^31; otherwise throws Error and changes nothing.
    // add(), move() and remove() take effect for box() at once, and for pairs() at update(). Boxes must have no NaN and
    // min <= max on each axis, which is not checked.
    virtual void add(ProxyIndex proxy, const Aabb& box) = 0;
    virtual void move(ProxyIndex proxy, const Aabb& box) = 0;  // `proxy` must be present
    virtual void remove(ProxyIndex proxy) = 0;                 // `proxy` must be present

    // Moves many boxes, in their order: if a proxy is named more than once, its last box counts. Moves all or none:
    // throws Error if a proxy is not present, or if the lists differ in length. Cost: less than one call for each box.
    virtual void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes) = 0;

    virtual Aabb box(ProxyIndex proxy) const = 0;   // `proxy` must be present
    virtual std::size_t size() const noexcept = 0;  // boxes present

    // Reserves memory for `count` boxes with numbers below `count`, so that adding them allocates little.
    virtual void reserve(std::size_t count) = 0;

    // Updates pairs() to the pairs of boxes that overlap now. Constant cost if nothing changed since the last update.
    // If memory runs out (std::bad_alloc), pairs() stays as it was, began() and ended() are empty, and the next update
    // finds all changes since the last one that succeeded.
    virtual void update() = 0;

    // Returns the pairs as of the last update, ascending. The list is valid until the next call that is not const. This
    // call brings the list up to date: in one pass over the list if pairs came or went since the last call, otherwise
    // at no cost.
    virtual const std::vector<ProxyPair>& pairs() = 0;

    // Return the pairs that began to overlap, and the pairs that ceased to, at the last update, ascending. The pairs of
    // a removed proxy count as ended. If the proxy's number was used again before the update, and the new box makes the
    // same pair, the pair is in both lists.
    virtual const std::vector<ProxyPair>& began() const noexcept = 0;
    virtual const std::vector<ProxyPair>& ended() const noexcept = 0;

    // Return the boxes that share a point with the given box, segment or ball, ascending. Boxes count as they are now,
    // even if update() has not been called since a change. Decided exactly; all broad phases give the same. Throws
    // InvalidArgument. Safe from many threads, as long as no call that is not const runs.
    //
    // Cost: brute_force and sweep_and_prune test all boxes; so do the others if they have few boxes. kept_candidates
    // and automatic make trees at the first such call (n log n, and about 150 bytes a box). After that, a call costs a
    // few tests for each box that it finds or that is close by, and for each level of the trees; and one test for each
    // box that was new or changed since the call before.
    virtual std::vector<ProxyIndex> find(const Aabb& box) const = 0;
    virtual std::vector<ProxyIndex> find(const Segment& segment) const = 0;
    virtual std::vector<ProxyIndex> find(const Ball& ball) const = 0;

    // Calls `visit` with boxes in ascending order of a lower bound of their distance from `box`, up to `limit`. `visit`
    // returns a new limit, which replaces the limit if it is smaller. All boxes within the limit are visited, and
    // perhaps some beyond it. Boxes count as they are now. Throws InvalidArgument for a bad box or limit; exceptions of
    // `visit` pass through. Safe from many threads, as find() is.
    //
    // Cost: brute_force tests all boxes; so do the others if they have few boxes. Otherwise trees are made as for
    // find(), and a call costs some tests for each box that is visited, and for each level of the trees.
    virtual void visit_near(const Aabb& box, double limit, const std::function<double(ProxyIndex)>& visit) const = 0;

    // Calls `visit` with pairs of boxes in ascending order of a lower bound of their distance, each pair once, up to
    // `limit`; `visit` and errors are as for visit_near(). A broad phase that tests all pairs visits them in the order
    // of pairs instead. Cost: brute_force tests all pairs; so do the others if they have few boxes. Otherwise some
    // tests for each pair of boxes within the limit, and for each pair of blocks of neighboring boxes within it.
    virtual void visit_near_pairs(double limit, const std::function<double(ProxyPair)>& visit) const = 0;

    // Calls `visit` with each box that the segment or ray may meet, or that `box` may meet while it is translated by
    // time times `motion`. Boxes come in ascending order of a lower bound of the first parameter or time of meeting, up
    // to the limit (1 for a segment, the largest parameter for a ray). `visit`, errors and cost are as for
    // visit_near().
    virtual void visit_along(const Segment& segment, const std::function<double(ProxyIndex)>& visit) const = 0;
    virtual void visit_along(const Ray& ray, const std::function<double(ProxyIndex)>& visit) const = 0;
    virtual void visit_along(const Aabb& box, const Vec3& motion, double limit,
                             const std::function<double(ProxyIndex)>& visit) const = 0;

    // Returns counts of the work of find(), visit_near(), visit_near_pairs() and visit_along().
    virtual FindCounts find_counts() const noexcept = 0;

    virtual const BroadPhaseCounts& counts() const noexcept = 0;

    // Returns the size of the memory held, scratch memory included, in bytes. Cost: constant for brute_force and
    // sweep_and_prune, otherwise proportional to the depth of the trees.
    virtual std::size_t bytes() const noexcept = 0;

    // Checks every invariant of the structure; throws BrokenInvariant. Call it after update(). May cost n^2.
    virtual void check_invariants() const = 0;
};

ECODS_API std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseKind kind);

}  // namespace ecods
