// A World holds many moving bodies, and answers which of them touch, which come close, and which is the nearest.
//
//     World world;
//     BodyId a = world.create_body(mesh, pose_a);
//     BodyId b = world.create_body(mesh, pose_b);
//     world.update();
//     for (BodyPair pair : world.colliding_pairs()) ...
//
// The world (FCL: CollisionManager; Box3D: b3World; Jolt: PhysicsSystem's queries) owns poses, shapes and boxes. A
// change (create, destroy, set) takes effect for questions at once, and for the lists at the next update(). The world
// does not move bodies, respond to contacts, or draw. (world_options.hpp)
//
// Lifetimes: a span is valid until the next call that is not const; all other results are returned by value. Arguments
// may be spans that the world returned. A world that was moved from can be assigned to and destroyed; is_alive()
// returns false for it, and every other call throws MovedFromWorld.
//
// Thread safety: several threads may make const calls at the same time, each with its own QueryMemory, if any. While a
// call that is not const runs, no other call may run.
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
#include "ecods/cast.hpp"
#include "ecods/certificate.hpp"
#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/export.hpp"
#include "ecods/hit.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "ecods/world_options.hpp"

namespace ecods {

class ECODS_API World {
  public:
    explicit World(const WorldOptions& options = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // ---- bodies

    // Creates a body. Throws InvalidArgument if mesh and shape are null or both are given, if the pose is not finite,
    // or if the caller's own shape returns a bad box; NotSupported if a test with the shape of some body is missing.
    BodyId create_body(const BodyOptions& options);
    BodyId create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose);
    BodyId create_body(std::shared_ptr<const Shape> shape, const Pose& pose);

    // Removes the body. Its id is stale from now on. Throws StaleBody if it is already; so does every call with an id.
    void destroy_body(BodyId body);

    // Sets the pose. To set the same pose again is not a move. Throws InvalidArgument if the pose is not finite.
    void set_pose(BodyId body, const Pose& pose);

    // Sets the poses of all these bodies, or of none if the call throws; of a body listed twice, the later pose. Throws
    // InvalidArgument if the lists differ in length. An error about an entry (also StaleBody) has its index.
    void set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses);

    // Sets the shape. To set the same object again is not a change. A mesh that deforms is a new shape each time.
    // Throws the errors of create_body().
    void set_shape(BodyId body, const std::shared_ptr<const Mesh>& mesh);
    void set_shape(BodyId body, std::shared_ptr<const Shape> shape);

    bool is_alive(BodyId body) const noexcept;
    Pose pose(BodyId body) const;
    std::shared_ptr<const Shape> shape(BodyId body) const;
    Aabb box(BodyId body) const;  // contains the exact body at its present pose and shape

    void set_user_data(BodyId body, std::uint64_t data);  // a number of the caller's; no answer or digest depends on it
    std::uint64_t user_data(BodyId body) const;           // set last; 0 at first

    // Return all ids, ascending; and the ids that the next calls of create_body() will give if no body is destroyed:
    // first the ids of free slots, then that of a new slot (WorldOptions::ids). Cost: one pass.
    std::vector<BodyId> bodies() const;
    std::vector<BodyId> next_ids() const;

    void reserve(std::size_t body_count);  // memory for so many bodies altogether: creating them moves nothing

    // ---- the clearance, and relations

    // Sets the greatest distance of close_pairs(); nullopt: no pair is close. The next update applies it, with the
    // events of the change. Real distances are compared. (FCL: security margin; Bullet: contact breaking threshold.)
    // Throws InvalidArgument if the distance is negative, NaN or infinite; NotSupported if a test that bodies here need
    // does not answer `within`. While a clearance is set, create_body(), set_shape() and set_test() throw it.
    void set_clearance(std::optional<double> clearance);
    std::optional<double> clearance() const;  // set last

    // Sets whether updates from the next one on make relations(); false at first. Throws NotSupported if a test that
    // bodies here need does not answer `relation`; while it is set, so do create_body(), set_shape() and set_test().
    void set_relations(bool are_listed);
    bool are_relations_listed() const;  // set last

    // ---- which pairs are tested at all
    //
    // A pair is filtered out if the filters of its bodies exclude it, or if it is switched off. It is then not tested,
    // and is in no list and no event, even if it collides. If a colliding pair becomes filtered out, the next update
    // reports that it ended; if it is filtered out no more, that it began; and likewise for close pairs. Questions
    // about everything skip pairs that are filtered out; questions about one pair ignore filters.

    void set_filter(BodyId body, const CollisionFilter& filter);
    CollisionFilter filter(BodyId body) const;

    // Switches one pair off, or on again, in either order of the arguments, until one of the bodies is destroyed.
    // Throws SameBody. Cost: logarithmic in the number of pairs that are off.
    void set_pair_enabled(BodyId a, BodyId b, bool is_enabled);
    bool is_pair_enabled(BodyId a, BodyId b) const;  // according to this switch, whatever the filters are
    std::vector<BodyPair> disabled_pairs() const;    // pairs that are off, ascending; cost: one pass over them

    // ---- two-body tests

    // Registers the test of two kinds, for either order of arguments (the world swaps them), in place of an earlier one
    // and its verdicts. Meshes, rounded shapes and half spaces have tests from the start. Throws InvalidArgument for
    // null.
    void set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test);

    // ---- answers for the whole world, as of the last update

    // Brings the lists below up to date. Work is proportional to the changes: a pair keeps its verdict if neither body
    // changed. If a caller's test throws, all other tests are still run, the error of the least pair that threw is
    // thrown, the lists stay as they were, and the next update does the work again; likewise for ExecutorFailed.
    void update();

    // Returns the candidates: pairs that are not filtered out and whose boxes overlap, a superset of the colliding
    // pairs. How tight boxes are is not promised, so this list alone may differ between versions and rounding modes.
    // Not const: the first call after an update that changed the list computes it, in one pass. After an update that
    // threw, the list is unspecified until an update succeeds.
    std::span<const BodyPair> overlapping_pairs();

    // Returns the pairs that share a point. Exact.
    std::span<const BodyPair> colliding_pairs() const;

    // Return the pairs that began to collide, and that ceased, at the last update (Box3D: begin and end events). If a
    // body is destroyed, its collisions end.
    std::span<const BodyPair> began() const;
    std::span<const BodyPair> ended() const;

    // Returns the pairs within the clearance of the last update, colliding pairs included; empty if it had none. Exact.
    std::span<const BodyPair> close_pairs() const;

    // Return the pairs that came within the clearance, and that left it, at the last update.
    std::span<const BodyPair> close_began() const;
    std::span<const BodyPair> close_ended() const;

    // Returns colliding_pairs() with the relation of the first body to the second. Exact; empty unless
    // set_relations(true) was called before the last update.
    std::span<const PairRelation> relations() const;

    // ---- answers for one pair, as of now
    //
    // Each question takes two subjects, each a body, or a shape or mesh at a pose. Questions do not change the world,
    // and ignore filters. All throw StaleBody, SameBody, NotSupported, and InvalidArgument for a bad pose.

    // Answer the questions of intersection.hpp and distance.hpp. If several pairs of features tie, closest() of two
    // bodies chooses as if the body with the lesser id came first.
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

    // Answer the questions of solid.hpp, and throw the same errors. Throw NotSupported if one of the two is no Solid,
    // or for depth() and signed_distance() no ConvexSolid, with two exceptions: both calls take a rounded body with
    // another one or with a mesh of any form, and answer as rounded.hpp says; and signed_distance() takes a half space
    // with any of these (solid.hpp). If several features tie, depth() and signed_distance() of two bodies choose as if
    // the body with the lesser id came first.
    [[nodiscard]] std::optional<Depth> depth(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] SignedDistance signed_distance(const Asked& a, const Asked& b, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<DepthBounds> depth_bounds(const Asked& a, const Asked& b, const Ask& ask = {}) const;

    // Returns the contact patch of the subjects, in the order given, as contact.hpp says; throws the same errors.
    [[nodiscard]] ContactPatch contact_patch(const Asked& a, const Asked& b, const PatchLimits& limits = {},
                                             const Ask& ask = {}) const;

    // ---- answers about everything, as of now
    //
    // All throw StaleBody and InvalidArgument for a bad subject. All throw NotSupported if a test that the question may
    // need, of the kinds of two bodies or of the subject and a body, does not answer it, however far away they are.

    // Returns the bodies whose boxes share a point with `box`, ascending: a superset of the bodies that share a point
    // with it. Cost: that of BroadPhase::find.
    [[nodiscard]] std::vector<BodyId> overlapping_bodies(const Aabb& box) const;

    // Returns the bodies that share a point with the subject, ascending. Exact. Cost: a two-body test for each box that
    // overlaps, beside BroadPhase::find. (Parry: intersections_with_shape; Box3D: overlap queries.)
    [[nodiscard]] std::vector<BodyId> intersecting_bodies(const Asked& subject, const Ask& ask = {}) const;

    // Returns the solids and rounded bodies that contain the point, inside or on their surfaces. Other bodies are not
    // asked. Exact. Cost: that of BroadPhase::find, and a locate() for each box that contains the point.
    [[nodiscard]] BodiesContaining bodies_containing(const Vec3& point, const Ask& ask = {}) const;

    // Returns the body nearest to the subject; nullopt if there is none within max_distance. NearestBody says which one
    // is returned if several tie. Throws InvalidArgument if max_distance is negative or NaN. Needs tests that answer
    // Question::within and Question::distance.
    [[nodiscard]] std::optional<NearestBody> nearest(const Asked& subject, double max_distance = no_limit,
                                                     const Ask& ask = {}) const;
    static constexpr double no_limit = std::numeric_limits<double>::infinity();

    // Return the closest pair, and all pairs, whose real distance is at most max_distance, with their points
    // (ClosestPair says in which order, and which distances are signed). With groups, only pairs count of which one
    // body is in a group of groups_a and the other one in a group of groups_b, in any order (CollisionFilter::groups).
    // Throw InvalidArgument if max_distance is negative or NaN. Need tests that answer Question::within and
    // Question::distance. If `ask` gives no memory, the executor runs closest_pairs(); calls of several threads then
    // take turns (ExecutorFailed).
    //
    // Cost of closest_pair: that of BroadPhase::visit_near_pairs; with groups, a pass over the bodies, and that of
    // visit_near from each body of the smaller group. The pair that was closest at the last call with the same memory
    // is asked first, so the counts depend on the calls before. Cost of closest_pairs: a pass over the bodies, trees of
    // boxes, and a test of `within` for each pair whose boxes may be near enough.
    [[nodiscard]] std::optional<ClosestPair> closest_pair(double max_distance = no_limit, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<ClosestPair> closest_pair(double max_distance, std::uint64_t groups_a,
                                                          std::uint64_t groups_b, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<ClosestPair> closest_pairs(double max_distance, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<ClosestPair> closest_pairs(double max_distance, std::uint64_t groups_a,
                                                         std::uint64_t groups_b, const Ask& ask = {}) const;

    // Returns the signed distances, without points, of the pairs that closest_pairs(max_distance) lists, ascending by
    // pair: for 0 those of colliding_pairs(), and for the clearance those of close_pairs(), as the bodies are now.
    // Throws, and runs the work, as closest_pairs() does.
    [[nodiscard]] std::vector<PairDistance> signed_distances(double max_distance, const Ask& ask = {}) const;

    // Returns the pairs of convex bodies (ConvexSolids, rounded bodies of the kind rounded_convex()) that share a
    // point, each with the Depth that depth() has; ascending. Minus the depth of a pair is its number in
    // signed_distances(0). Throws SingularPose if any ConvexSolid in the world has a singular pose, or depth() of a
    // pair throws it; ExecutorFailed. Runs the work as closest_pairs() does.
    [[nodiscard]] std::vector<BodyDepth> depths(const Ask& ask = {}) const;

    // Returns the contact patches of those colliding_pairs() that contact_patch() takes, in the order of that list, the
    // body of the lesser id first. Bodies that were moved since the last update are where they are now, and may be
    // apart. Throws SingularPose and InvalidArgument.
    [[nodiscard]] std::vector<BodyPatch> contact_patches(const PatchLimits& limits = {}, const Ask& ask = {}) const;

    // Return the first hit, or all hits, of a segment or ray (hit.hpp) with the bodies that the filter, if any, may
    // meet, in the order of BodyHit. Throw InvalidArgument; NotSupported if the shape of any body here has no hits.
    using Filter = std::optional<CollisionFilter>;
    [[nodiscard]] std::optional<BodyHit> first_hit(const Segment& line, Filter filter = {}, const Ask& ask = {}) const;
    [[nodiscard]] std::optional<BodyHit> first_hit(const Ray& line, Filter filter = {}, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyHit> all_hits(const Segment& line, Filter filter = {}, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyHit> all_hits(const Ray& line, Filter filter = {}, const Ask& ask = {}) const;
    // Return all_hits() of each line. The error's `index` says which line is not valid.
    [[nodiscard]] BodyHitLists all_hits(std::span<const Segment> lines, Filter filter = {}, const Ask& ask = {}) const;
    [[nodiscard]] BodyHitLists all_hits(std::span<const Ray> lines, Filter filter = {}, const Ask& ask = {}) const;

    // Return all_hits() with normals and sides; and the parts of the line that are inside solids (hit.hpp). Surfaces
    // have no inside. Throw InvalidArgument, and NotSupported if the shape of any body here is no mesh or solid.
    [[nodiscard]] std::vector<BodySidedHit> sided_hits(const Segment& line, Filter filter = {},
                                                       const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodySidedHit> sided_hits(const Ray& line, Filter filter = {}, const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyInsidePart> inside_parts(const Segment& line, Filter filter = {},
                                                           const Ask& ask = {}) const;
    [[nodiscard]] std::vector<BodyInsidePart> inside_parts(const Ray& line, Filter filter = {},
                                                           const Ask& ask = {}) const;

    // Suppose that the subject is translated by t * `motion` at each time t (cast.hpp), or moves in any way
    // (pose.hpp); nothing is moved. Return the body that it meets first, or nullopt if it meets none up to max_time.
    // A max_time above 1 counts as 1. Throw the errors of casts of two bodies. Need tests that answer Question::cast;
    // for straight motions cast_moving; for turns cast_any_motion, which the library has for meshes alone.
    [[nodiscard]] std::optional<BodyContact> cast(const Asked& subject, const Vec3& motion, double max_time = 1,
                                                  const Ask& ask = {}) const;
    [[nodiscard]] std::optional<BodyContact> cast(const Asked& subject, const Motion& motion, double max_time = 1,
                                                  const Ask& ask = {}) const;

    // Returns the first body that a deforming mesh (cast.hpp) meets. Throws NotSupported if a body that the filter
    // may meet is no mesh or solid. It is not traced. Cost: that of BroadPhase::find, and of the casts.
    [[nodiscard]] std::optional<BodyContact> cast(const Deforming& mesh, double max_time = 1, Filter filter = {},
                                                  const Ask& ask = {}) const;

    // Returns the first body within `distance` of the translated subject (cast.hpp, with its errors).
    // Throws NotSupported unless the subject and all bodies that it may meet are meshes or rounded bodies.
    [[nodiscard]] std::optional<BodyContact> cast_to_distance(const Asked& subject, const Vec3& motion, double distance,
                                                              double max_time = 1, const Ask& ask = {}) const;

    // Returns the first body that the translated subject enters before max_time (cast.hpp, with its errors), by rounded
    // times, then ids. Throws NotSupported unless the subject and all bodies that it may meet are surfaces, or all are
    // solids with inner points.
    [[nodiscard]] std::optional<BodyEntry> entering(const Asked& subject, const Vec3& motion, double max_time = 1,
                                                    const Ask& ask = {}) const;

    // Returns the point and normal of a contact that cast(subject, motion) returned (contact.hpp, with its errors).
    [[nodiscard]] ContactPoint contact_point(const Asked& subject, const Vec3& motion, const BodyContact& contact,
                                             const Ask& ask = {}) const;

    // Return all pairs that meet while each of the bodies moves, straight to its new pose or in any way (pose.hpp),
    // and all other bodies stay. Meeting says in which order. If a body is listed twice, its later motion counts. Throw
    // the errors of set_poses(), of validate() for motions, and of the casts of turns (turn.hpp). Need tests that
    // answer Question::cast_moving, and cast_any_motion if a body turns or is translated.
    [[nodiscard]] std::vector<Meeting> meetings(std::span<const BodyId> bodies, std::span<const Pose> poses,
                                                const Ask& ask = {}) const;
    [[nodiscard]] std::vector<Meeting> meetings(std::span<const BodyId> bodies, std::span<const Motion> motions,
                                                const Ask& ask = {}) const;

    // ---- a record of every call that changes the world (trace.hpp)

    // Begins a trace: writes the present bodies and settings, then every call that succeeds. The trace ends at
    // end_trace(), at another trace_to(), or with the world; the stream must outlive it. Cost: the text, and a digest
    // at each update. Throws NotSupported, and begins no trace, if the shape of a body cannot be written; create_body()
    // and set_shape() throw it while a trace runs. If the stream fails, the trace ends; calls still succeed.
    void trace_to(std::ostream& out, TraceOptions options = {});
    void end_trace();  // if there is one. Throws TraceFailed if a part of the trace could not be written

    // ---- inspection

    // Returns colliding_pairs() and close_pairs() with a proof (certificate.hpp). Throws NotUpdated, NotSupported.
    WorldCertificate certify(const Ask& ask = {}) const;
    Statistics statistics() const;

    // Checks every invariant, and repeats the test of every cached verdict. Call it after an update that succeeded.
    // Throws BrokenInvariant; ShapeChanged if a caller's shape has changed. Slow: for tests.
    void check_invariants() const;

    // Returns a hash of the bodies (shapes, poses) and of the colliding pairs as of the last update, and of the
    // clearance, the close pairs and the relations that this update had. Equal scenes have equal digests, whatever
    // their ids, history or broad phase are. A filter affects the digest only through the pairs that it removes.
    std::uint64_t digest() const;

  private:
    friend struct WorldAccess;
    struct ECODS_HIDDEN Impl;
    ECODS_HIDDEN Impl& impl();  // throw MovedFromWorld
    ECODS_HIDDEN const Impl& impl() const;

    std::unique_ptr<Impl> impl_;  // null if moved from
};

}  // namespace ecods
