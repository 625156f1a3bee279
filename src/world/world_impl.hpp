// The inside of a World.
#pragma once

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "ecods/world.hpp"
#include "world/two_body_tests.hpp"
#include "world/verdict_cache.hpp"

namespace ecods {

// A place for a body. Slot numbers are the broad phase's proxies; id.slot is one more.
struct Slot {
    std::uint32_t generation = 0;
    bool is_changed = false;             // listed in `changed`, where it stays if its body is destroyed
    std::shared_ptr<const Shape> shape;  // null: free
    Pose pose;
    Aabb box;

    bool is_alive() const noexcept { return shape != nullptr; }
    PosedShape posed() const noexcept { return {*shape, pose}; }
};

struct World::Impl {
    explicit Impl(const WorldOptions& options);

    // ---- bodies
    ProxyIndex require(BodyId body) const;  // throws StaleBody
    BodyId id_of(ProxyIndex proxy) const { return {proxy + 1, slots[proxy].generation}; }
    BodyPair ids_of(ProxyPair pair) const { return {id_of(pair.a), id_of(pair.b)}; }
    std::shared_ptr<const Shape> shape_of(const std::shared_ptr<const Mesh>& mesh);
    void require_tests_for(ShapeKind kind, const Shape* replaced) const;  // throws MissingTest
    void mark_changed(ProxyIndex proxy);

    // ---- pairs of bodies
    OrderedTest test_of(ProxyPair pair) const;
    bool test(ProxyPair pair, QueryMemory& query_memory) const;

    // ---- update
    void take_over_candidates();
    void test_changed_pairs();
    void commit();
    void commit_candidates();
    void commit_verdicts();

    std::vector<Slot> slots;
    std::vector<ProxyIndex> free_slots;
    std::map<ShapeKind, std::size_t> kind_counts;  // of living bodies
    std::unordered_map<const Mesh*, std::weak_ptr<const MeshShape>> mesh_shapes;
    std::size_t mesh_shapes_max = 16;  // when that many are known, forget those that are gone
    TwoBodyTests tests;
    std::unique_ptr<BroadPhase> broad_phase;
    VerdictCache verdicts;
    QueryMemory memory;

    // What changed since the last update that succeeded.
    std::vector<ProxyIndex> changed;
    bool candidates_are_dirty = false;  // bodies were removed
    bool update_failed = false;         // the lists below lag behind the cache
    std::vector<BodyPair> lost;         // colliding pairs that are no candidates any more

    struct TestedPair {
        ProxyPair pair;
        bool colliding;
    };
    std::vector<TestedPair> tested;  // by the update under way

    std::vector<BodyPair> overlapping, colliding, began, ended;
    Statistics statistics;  // sums; the rest is filled in on request
};

}  // namespace ecods
