// Many moving bodies: which of them touch?
//
//     World world;
//     BodyId a = world.create_body(mesh, pose_a);
//     BodyId b = world.create_body(mesh, pose_b);
//     world.update();
//     for (BodyPair pair : world.colliding_pairs()) ...
//
// The world owns poses, shapes and boxes. Changes (create, destroy, set) take effect at once for questions about a
// pair (relation, touching_triangles), and at update() for the lists. There is nothing else to call, and no call
// whose omission makes an answer wrong.
//
// The world does not move bodies, respond to contacts, or draw.
//
// Thread safety: const calls may run beside each other; every other call needs the world alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/error.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"
#include "ecods/shape.hpp"
#include "ecods/two_body.hpp"

namespace ecods {

struct WorldOptions {
    BroadPhaseKind broad_phase = BroadPhaseKind::sweep_and_prune;
};

// What the world did, as counts. `updates` to `cache_hits` sum over the world's life; the rest is of now.
struct Statistics {
    std::uint64_t updates = 0;
    std::uint64_t moved_bodies = 0;     // bodies that were new or changed at an update
    std::uint64_t two_body_tests = 0;   // candidate pairs given to a two-body test at updates
    std::uint64_t cache_hits = 0;       // candidate pairs whose verdict was kept at updates
    BroadPhaseCounts broad_phase;
    QueryCounts queries;                // of mesh pairs, at updates and on request

    std::size_t body_count = 0;
    std::size_t overlapping_count = 0;  // as of the last update
    std::size_t colliding_count = 0;
};

class World {
  public:
    explicit World(const WorldOptions& options = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // ---- bodies

    // Makes a body. Throws NullArgument, InvalidPose, InvalidBox, or MissingTest when a body of another kind is here
    // and no test for the two kinds is. Bodies given the same Mesh share its tree.
    BodyId create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose);
    BodyId create_body(std::shared_ptr<const Shape> shape, const Pose& pose);

    // The id, and every copy of it, is stale from now on. Throws StaleBody, as does every call that is given an id.
    void destroy_body(BodyId body);

    // Throws InvalidPose. Setting the very pose that the body has is not a move.
    void set_pose(BodyId body, const Pose& pose);

    // Throws as create_body does. Setting the very object that the body has is not a change.
    void set_shape(BodyId body, std::shared_ptr<const Mesh> mesh);
    void set_shape(BodyId body, std::shared_ptr<const Shape> shape);

    bool is_alive(BodyId body) const noexcept;
    const Pose& pose(BodyId body) const;
    const std::shared_ptr<const Shape>& shape(BodyId body) const;
    const Aabb& box(BodyId body) const;  // contains the exact body; of the pose and shape set last

    // All bodies, ascending. Cost: one pass.
    std::vector<BodyId> bodies() const;

    // ---- two-body tests

    // Registers the test for two kinds, in either order of arguments (the world swaps them); replaces what was there,
    // and forgets the verdicts that it gave. Meshes have one from the start. Throws NullArgument.
    void set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test);

    // ---- answers for the whole world, as of the last update

    // Brings the lists below up to date. Work is proportional to what changed: pairs of which neither body changed
    // keep their verdict. When a caller's shape or test throws, the lists stay as they were, and the next update
    // does the work again.
    void update();

    // Pairs whose boxes overlap: the candidates, a superset of the colliding ones. How tight boxes are is not
    // promised, so this list, unlike all else, may differ between versions and rounding modes.
    std::span<const BodyPair> overlapping_pairs() const noexcept;

    // Pairs that share a point. Exact.
    std::span<const BodyPair> colliding_pairs() const noexcept;

    // Pairs that began and ended to collide with the last update. A destroyed body's collisions end.
    std::span<const BodyPair> began() const noexcept;
    std::span<const BodyPair> ended() const noexcept;

    // ---- answers for one pair, as of now

    // Either order of arguments. Throw StaleBody, SameBody, NotSupported. They change no answer, but work in the world's
    // query memory, hence are not const. (From many threads, use the functions of two_body.hpp.)
    bool intersects(BodyId a, BodyId b);
    Relation relation(BodyId a, BodyId b);
    std::vector<TrianglePair> touching_triangles(BodyId a, BodyId b);

    // ---- inspection

    Statistics statistics() const;

    // Checks every invariant, the broad phase's and the cache's own included, and that kept verdicts are those of a
    // fresh test. Throws BrokenInvariant. Slow: for tests. Call it after update().
    void validate() const;

    // A hash of the bodies (shapes, poses) and of which of them collide, as of the last update. It does not depend on
    // ids, on the order of creation, on history, or on the broad phase: equal scenes have equal digests.
    std::uint64_t digest() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ecods
