// Many moving bodies: which of them touch, which come close, and which is the nearest?
//
//     World world;
//     BodyId a = world.create_body(mesh, pose_a);
//     BodyId b = world.create_body(mesh, pose_b);
//     world.update();
//     for (BodyPair pair : world.colliding_pairs()) ...
//
// The world (FCL: CollisionManager; Box3D: b3World; Jolt: PhysicsSystem's queries) owns poses, shapes and boxes.
// Changes (create, destroy, set) take effect at once for questions, and at update() for the lists. There is nothing
// else to call, and no call whose omission makes an answer wrong.
//
// statistics.hpp has the world's costs. The world does not move bodies, respond to contacts, or draw.
//
// Lifetimes: a span is valid until the next call that is not const; everything else is returned by value. Arguments may
// be the world's own answers. A world that was moved from can be assigned to and destroyed; every other call throws
// MovedFromWorld, but is_alive(), which is false.
//
// Thread safety: const calls may run beside each other, each with a QueryMemory of its own where it is given one; every
// other call needs the world alone.
//
// Example: verify/examples/how_do_i, world_with_events().
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/certificate.hpp"
#include "ecods/error.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "ecods/statistics.hpp"
#include "ecods/two_body_test.hpp"
#include "ecods/world_options.hpp"

namespace ecods {

class ECODS_API World {
  public:
    explicit World(const WorldOptions& options = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // ---- bodies

    // Makes a body. Throws InvalidArgument for a null mesh or shape, for both at once, for a pose that is not finite,
    // and for a bad box of the caller's own shape; NotSupported if a test that it needs with a body here is missing, or
    // does not answer `within` while there is a clearance.
    BodyId create_body(const BodyOptions& options);
    BodyId create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose);
    BodyId create_body(std::shared_ptr<const Shape> shape, const Pose& pose);

    // Removes the body. Its id, and every copy of it, is stale from now on. Throws StaleBody, as does every call that
    // is given an id.
    void destroy_body(BodyId body);

    // Throws InvalidArgument. Setting the very pose that the body has is not a move.
    void set_pose(BodyId body, const Pose& pose);

    // Sets the pose of each body: all of them, or none if a call throws. For a body that is listed twice the later pose
    // holds. Throws InvalidArgument if the lists differ in length. Errors about one entry (InvalidArgument, StaleBody)
    // have its index.
    void set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses);

    // Throws as create_body does. Setting the very object that the body has is not a change. A mesh that deforms is a
    // new shape each time.
    void set_shape(BodyId body, const std::shared_ptr<const Mesh>& mesh);
    void set_shape(BodyId body, std::shared_ptr<const Shape> shape);

    bool is_alive(BodyId body) const noexcept;
    Pose pose(BodyId body) const;
    std::shared_ptr<const Shape> shape(BodyId body) const;
    Aabb box(BodyId body) const;  // contains the exact body, as its pose and shape were set last

    // Keeps a number of the caller's with the body; 0 at first. It reaches no answer and no digest.
    void set_user_data(BodyId body, std::uint64_t data);
    std::uint64_t user_data(BodyId body) const;

    // bodies() returns all ids, ascending. next_ids() returns the ids that the next create_body() calls give if no body
    // is destroyed: those of free slots first, then one of a new slot (WorldOptions::ids). Cost: one pass.
    std::vector<BodyId> bodies() const;
    std::vector<BodyId> next_ids() const;

    // Reserves memory for so many bodies in all, so that creating them moves nothing.
    void reserve(std::size_t body_count);

    // ---- the clearance

    // Sets the distance up to which pairs are close_pairs() from the next update on, decided for the real number;
    // empty: no pair is. (FCL: security margin; Bullet: contact breaking threshold.) The next update has events for the
    // change. Throws InvalidArgument if the distance is negative, NaN or infinite; NotSupported if a test that bodies
    // here need does not answer `within`. While there is a clearance, create_body, set_shape and set_test throw
    // NotSupported for that reason, too.
    void set_clearance(std::optional<double> clearance);
    std::optional<double> clearance() const;  // set last

    // ---- solids
    //
    // A body is a solid if its shape is a Solid (solid.hpp), and a surface in everything else, collisions included.

    // Sets whether updates make solid_pairs(), from the next one on; false at first.
    void set_solids(bool are_related);
    bool are_solids_related() const;  // set last

    // ---- which pairs are tested at all
    //
    // A pair is filtered out when the filters of its bodies say so, or when it is switched off. It is then not tested,
    // and is in no list and no event, even if it collides. If a colliding pair becomes filtered, it has ended at the
    // next update; if it is filtered no more, it has begun. So it is for close pairs, too. nearest(), closest_pair(),
    // cast(), meetings(), depths() and solid_distances() pass over it. Questions about a pair are about geometry:
    // filters do not count.

    void set_filter(BodyId body, const CollisionFilter& filter);
    CollisionFilter filter(BodyId body) const;

    // Switches one pair off, or on again. Either order of arguments. It is forgotten when one of the two is destroyed.
    // Throws SameBody. Cost: logarithmic in the pairs that are off.
    void set_pair_enabled(BodyId a, BodyId b, bool is_enabled);
    bool is_pair_enabled(BodyId a, BodyId b) const;  // by that switch alone, whatever the filters are
    std::vector<BodyPair> disabled_pairs() const;    // all that are off, ascending; cost: one pass over them

    // ---- two-body tests

    // Registers the test for two kinds, in either order of arguments (the world swaps them); replaces the one that was
    // there, and forgets the verdicts that it gave. Meshes have one from the start. Throws InvalidArgument for null.
    void set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test);

    // ---- answers for the whole world, as of the last update

    // Brings the lists below up to date. Work is proportional to what changed: pairs of which neither body changed
    // keep their verdict. When a caller's test throws, all other tests are still run; then the error of the pair that
    // comes first is thrown, the lists stay as they were, and the next update does the work again. So it is when
    // the executor throws, or fails (ExecutorFailed).
    void update();

    // Returns the pairs whose boxes overlap and that are not filtered out: the candidates, a superset of the colliding
    // ones. How tight boxes are is not promised, so this list, unlike all else, may differ between versions and
    // rounding modes. The first call after an update that changed the list makes it, in one pass over the candidates,
    // so this call is not const. After an update that threw, the list is unspecified until one succeeds.
    std::span<const BodyPair> overlapping_pairs();

    // Returns the pairs that share a point. Exact.
    std::span<const BodyPair> colliding_pairs() const;

    // Return the pairs that began and ended to collide with the last update (Box3D: begin and end events). A destroyed
    // body's collisions end.
    std::span<const BodyPair> began() const;
    std::span<const BodyPair> ended() const;

    // Returns the pairs within the clearance that the last update was made with, colliding ones included; empty without
    // one. Exact.
    std::span<const BodyPair> close_pairs() const;

    // Return the pairs that came within the clearance, and that left it, with the last update; these lists are apart
    // from began() and ended(), and follow the same rules.
    std::span<const BodyPair> close_began() const;
    std::span<const BodyPair> close_ended() const;

    // Returns the pairs of solids that are not apart. Exact; empty unless set_solids(true) was called before the last
    // update.
    std::span<const SolidPair> solid_pairs() const;

    // ---- answers for one pair, as of now
    //
    // Each question takes two subjects: bodies, or shapes or meshes at poses. Questions do not change the world, and
    // ignore filters. All throw StaleBody, SameBody, NotSupported, and InvalidArgument for a bad pose.

    // These answer as intersection.hpp and distance.hpp say. Where several pairs of features tie, closest() of two
    // bodies chooses as if the body of the lesser id came first.
    [[nodiscard]] bool intersects(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] Relation relation(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<TrianglePair> intersecting_triangles(const Asked& a, const Asked& b,
                                                                   const Ask& ask = {}) const;
    [[nodiscard]] std::vector<TriangleIntersection> intersections(const Asked& a, const Asked& b,
                                                                  const Ask& ask = {}) const;
    [[nodiscard]] double distance(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] bool within(const Asked& a, const Asked& b, double max_distance, const Ask& ask = {}) const;
    [[nodiscard]] ClosestPoints closest(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<CloseFeatures> close_features(const Asked& a, const Asked& b, double max_distance,
                                                            const Ask& ask = {}) const;

    // These answer as solid.hpp says, with its errors; NotSupported if one of the two is no Solid, or no ConvexSolid
    // where that is needed. Where several features tie, solid_closest() and depth() of two bodies choose as if the body
    // of the lesser id came first, whichever moves.
    [[nodiscard]] Relation solid_relation(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] double solid_distance(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<ClosestPoints> solid_closest(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<Depth> depth(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<DepthBounds> depth_bounds(const Asked& a, const Asked& b, const Ask& ask = {}) const;

    // ---- answers about everything, as of now
    //
    // All throw StaleBody and InvalidArgument for a bad subject; and NotSupported if a test that the question may need
    // (for the kinds of two bodies, or of the subject and a body) does not answer it, even if these bodies are far
    // away.

    // Returns the bodies whose boxes share a point with this one, ascending: a superset of those that reach into it.
    // Cost: that of BroadPhase::find.
    [[nodiscard]] std::vector<BodyId> overlapping_bodies(const Aabb& box) const;

    // Returns the bodies that share a point with the subject, ascending. Exact. Cost: as above, and a two-body test for
    // each box that overlaps. (Parry: intersections_with_shape; Box3D: overlap queries.)
    [[nodiscard]] std::vector<BodyId> intersecting_bodies(const Asked& subject, const Ask& ask = {}) const;

    // Returns the solids that hold the point, inside or on their surface. Exact. Cost: that of BroadPhase::find, and a
    // locate() for each box that contains the point.
    [[nodiscard]] BodiesContaining bodies_containing(const Vec3& point, const Ask& ask = {}) const;

    // Return the body nearest to the subject, and the closest pair that is not filtered out (NearestBody says which of
    // several); empty if none is at a distance of at most max_distance. Throw InvalidArgument if that is negative or
    // NaN. Need tests that answer Question::within and Question::distance.
    [[nodiscard]] std::optional<NearestBody> nearest(const Asked& subject, double max_distance = no_limit,
                                                     const Ask& ask = {}) const;
    [[nodiscard]] std::optional<ClosestPair> closest_pair(double max_distance = no_limit, const Ask& ask = {}) const;
    static constexpr double no_limit = std::numeric_limits<double>::infinity();

    // Return the pairs of convex solids that share a point, and the pairs within max_distance, decided for the real
    // number; ascending. Throw SingularPose if a convex solid is at one, wherever it is; InvalidArgument;
    // ExecutorFailed. If `ask` gives no memory, the executor runs them; calls of several threads then wait for each
    // other.
    [[nodiscard]] std::vector<BodyDepth> depths(const Ask& ask = {}) const;
    [[nodiscard]] std::vector<SolidDistance> solid_distances(double max_distance, const Ask& ask = {}) const;

    // Return the first hit, or all hits, of a segment or ray (hit.hpp) with the bodies; with a filter, only with bodies
    // that it may meet. BodyHit says in which order. Throw InvalidArgument; and NotSupported if a kind that is here
    // does not answer hits, wherever its bodies are.
    [[nodiscard]] std::optional<BodyHit> first_hit(const Segment& segment, std::optional<CollisionFilter> filter = {},
                                                   const Ask& ask = {}) const;
    [[nodiscard]] std::optional<BodyHit> first_hit(const Ray& ray, std::optional<CollisionFilter> filter = {},
                                                   const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyHit> all_hits(const Segment& segment, std::optional<CollisionFilter> filter = {},
                                                const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyHit> all_hits(const Ray& ray, std::optional<CollisionFilter> filter = {},
                                                const Ask& ask = {}) const;

    // Returns the body that the subject meets first while it is translated by time times `motion` (cast.hpp), up to
    // max_time. Nothing moves. Throws InvalidArgument if the motion is not finite, or max_time is negative or NaN;
    // above 1 counts as 1. Needs tests that answer Question::cast.
    [[nodiscard]] std::optional<BodyContact> cast(const Asked& subject, const Vec3& motion, double max_time = 1,
                                                  const Ask& ask = {}) const;

    // Returns all pairs, but for those that are filtered out, that meet while each of the bodies goes from where it is
    // to its new pose, as Moving does, and the others stay, in the order that Meeting names. For a body listed twice
    // the later pose holds. Throws as set_poses(). Needs tests that answer Question::cast_moving.
    [[nodiscard]] std::vector<Meeting> meetings(std::span<const BodyId> bodies, std::span<const Pose> poses,
                                                const Ask& ask = {}) const;

    // ---- a record of every call that changes the world (trace.hpp)

    // Begins a trace: writes what is here now, then every call as it succeeds. The stream must outlive the trace, which
    // ends with end_trace(), with the world, or with another trace_to(). It costs nothing when off; when on, the text,
    // and a digest at each update. Throws NotSupported when a body's shape cannot be written: no trace is then under
    // way. While a trace is under way, create_body and set_shape also throw NotSupported for such a shape. If the
    // stream fails, the trace ends; the calls of the world still succeed.
    void trace_to(std::ostream& out, TraceOptions options = {});

    // Ends the trace, if there is one. Throws TraceFailed when not all of it could be written.
    void end_trace();

    // ---- inspection

    // Returns colliding_pairs() and close_pairs() with their proof: certificate.hpp says more. Throws NotUpdated,
    // NotSupported.
    WorldCertificate certify(const Ask& ask = {}) const;
    Statistics statistics() const;

    // Checks every invariant, the broad phase's included, and kept verdicts by fresh tests, after an update that
    // succeeded. Throws BrokenInvariant; ShapeChanged when a caller's shape is not what it was. Slow: for tests.
    void check_invariants() const;

    // Returns a hash of the bodies (shapes, poses) and of which of them collide, as of the last update; where that was
    // made with a clearance, also of the clearance and the pairs within it; where with solids related, also of their
    // pairs. Equal scenes have equal digests, whatever their ids, history or broad phase. A filter affects the digest
    // only through the pairs that it removes.
    std::uint64_t digest() const;

  private:
    struct ECODS_HIDDEN Impl;
    ECODS_HIDDEN Impl& impl();  // throw MovedFromWorld
    ECODS_HIDDEN const Impl& impl() const;

    std::unique_ptr<Impl> impl_;  // null: moved from
};

}  // namespace ecods
