// The inside of a World.
#pragma once

#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "base/make_room.hpp"
#include "ecods/world.hpp"
#include "trace/trace_writer.hpp"
#include "world/disabled_pairs.hpp"
#include "world/sorted_pairs.hpp"
#include "world/two_body_tests.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// What happened to a body since the last update that succeeded.
enum class Change : std::uint8_t {
    none = 0,
    filter = 1,  // its filter alone: verdicts hold where the pair was not filtered out and is not now
    test = 2,    // the test of its kind: its verdicts are void, though it did not move
    body = 3,    // itself: its verdicts are void
};

// A place for a body. Slot numbers are the broad phase's proxies; id.slot is one more. What updates look at much lies
// apart: its box in `boxes`, and what changed in `changes`.
struct Slot {
    static constexpr std::uint16_t generation_max = std::numeric_limits<std::uint16_t>::max();

    std::uint16_t generation = 0;
    ShapeKind kind;
    std::shared_ptr<const Shape> shape;  // null: free
    Pose pose;
    CollisionFilter filter;
    std::uint64_t user_data = 0;
    std::uint64_t shape_digest = 0;

    bool is_alive() const noexcept { return shape != nullptr; }
    Posed<Shape> posed() const noexcept { return {*shape, pose}; }
};

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // ---- bodies
    bool is_alive(BodyId body) const noexcept;
    ProxyIndex require(BodyId body, const ListIndex& index = {}) const;  // throws StaleBody
    ProxyPair require_pair(BodyId a, BodyId b) const;                    // ... and SameBody; ascending
    BodyId id_of(ProxyIndex proxy) const { return {proxy + 1, slots[proxy].generation, number}; }
    BodyPair ids_of(ProxyPair pair) const { return {id_of(pair.a), id_of(pair.b)}; }
    std::shared_ptr<const Shape> shape_of(const std::shared_ptr<const Mesh>& mesh);
    std::shared_ptr<const MeshShape> known_shape_of(const std::shared_ptr<const Mesh>& mesh) const;  // or null
    void require_tests_for(ShapeKind kind, const Shape* replaced) const;  // throws MissingTest
    void put_shape(Slot& slot, std::shared_ptr<const Shape> shape) noexcept;
    void mark_changed(ProxyIndex proxy, Change change) noexcept;  // room in `changed` must have been made

    // ---- pairs of bodies
    OrderedTest test_of(ProxyPair pair) const { return tests.find(slots[pair.a].kind, slots[pair.b].kind); }
    bool test(ProxyPair pair, QueryMemory& memory) const;
    bool test_again(VerdictIndex verdict, QueryMemory& memory);
    bool is_enabled(ProxyPair pair) const noexcept {
        return may_meet(slots[pair.a].filter, slots[pair.b].filter) && !disabled.contains(pair);
    }

    // ---- update, in this order
    void update();
    void take_over_candidates();
    void take_over_events();
    void collect_pairs();
    void collect_pair(VerdictIndex index);
    void test_pairs();
    void commit();
    void build_overlapping();

    std::size_t memory_bytes() const noexcept;
    std::uint64_t digest() const;

    // The number of a shape in the trace, written before a call that brings it in; 0 without a trace.
    void trace_body(ProxyIndex proxy, std::uint64_t shape_number) noexcept;  // as the calls that make it
    std::uint64_t traced_number(const std::shared_ptr<const Shape>& shape) {
        return trace ? trace->number_of(shape) : 0;
    }

    const std::uint16_t number;  // of this world, for its ids
    std::vector<Slot> slots;
    std::vector<Aabb> boxes;      // by proxy
    std::vector<Change> changes;  // by proxy; if not none, listed in `changed`, also when its body is destroyed
    std::vector<ProxyIndex> free_slots;
    std::size_t retired_count = 0;  // slots that were used once for each generation: neither free nor used
    std::map<ShapeKind, std::size_t> kind_counts;  // of living bodies
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> mesh_shapes;
    std::size_t mesh_shapes_max = 16;  // when that many are known, forget those that are gone
    TwoBodyTests tests;
    DisabledPairs disabled;
    std::unique_ptr<BroadPhase> broad_phase;
    VerdictCache verdicts;
    std::shared_ptr<Executor> executor;
    std::vector<QueryMemory> memories;  // one a worker; the first is also for questions about a pair

    // What changed since the last update that succeeded.
    std::vector<ProxyIndex> changed;
    std::vector<ProxyPair> switched;    // pairs that were switched on or off
    bool candidates_are_dirty = false;  // bodies were removed
    bool events_are_pending = false;    // the broad phase has found what the cache does not know yet
    bool update_failed = false;         // the lists below lag behind the cache
    BodyPairs lost;                     // colliding pairs that are no candidates any more, in no order

    // The pairs that the update under way looks at.
    enum class Answer : std::uint8_t { none, filtered_out, disjoint, colliding };
    struct PairTest {
        VerdictIndex verdict;
        Answer answer;  // none: to be tested
    };
    std::vector<PairTest> pair_tests;

    std::unique_ptr<TraceWriter> trace;  // null: none is under way

    BodyPairs overlapping;  // made when asked for
    bool overlapping_is_stale = false;
    BodyPairs colliding, began, ended;
    BodyPairs next_began, next_ended;  // of the update under way
    Statistics statistics;             // sums; the rest is filled in on request
};

// The shape's box, checked: what enters the broad phase must be ordered.
Aabb box_for(const Shape& shape, const Pose& pose, BodyId body = {}, const ListIndex& index = {});
void require_valid(const Pose& pose, BodyId body = {}, const ListIndex& index = {});
void require_usable(const std::shared_ptr<const Shape>& shape);  // throws NullArgument, and
void require_mesh_kind(const Shape& shape);                      // NotSupported: the kind of meshes, but no MeshShape

}  // namespace ecods
