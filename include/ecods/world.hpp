// Many moving bodies: which of them touch, which come close, and which is the nearest?
//
//     World world;
//     BodyId a = world.create_body(mesh, pose_a);
//     BodyId b = world.create_body(mesh, pose_b);
//     world.update();
//     for (BodyPair pair : world.colliding_pairs()) ...
//
// The world owns poses, shapes and boxes. Changes (create, destroy, set) take effect at once for questions about a
// pair (relation, intersecting_triangles), and at update() for the lists. There is nothing else to call, and no call
// whose omission makes an answer wrong.
//
// Its costs are in statistics.hpp. The world does not move bodies, respond to contacts, or draw.
//
// Lifetimes: a span is valid until the next call that is not const; everything else is returned by value. Arguments may
// be the world's own answers. A world that was moved from can be assigned to and destroyed; every other call throws
// MovedFromWorld, but is_alive(), which is false.
//
// Thread safety: const calls may run beside each other, each with a QueryMemory of its own where it takes one; every
// other call needs the world alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/certificate.hpp"
#include "ecods/closest_points.hpp"
#include "ecods/collision_filter.hpp"
#include "ecods/depth.hpp"
#include "ecods/error.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "ecods/statistics.hpp"
#include "ecods/trace.hpp"
#include "ecods/world_answers.hpp"
#include "ecods/world_options.hpp"

namespace ecods {

class ECODS_API World {
  public:
    explicit World(const WorldOptions& options = {});
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    // ---- bodies

    // Makes a body. Throws InvalidArgument, or NotSupported when a body of another kind is here and no test for the two
    // kinds is.
    BodyId create_body(const BodyOptions& options);
    BodyId create_body(std::shared_ptr<const Mesh> mesh, const Pose& pose);
    BodyId create_body(std::shared_ptr<const Shape> shape, const Pose& pose);

    // The id, and every copy of it, is stale from now on. Throws StaleBody, as does every call that is given an id.
    void destroy_body(BodyId body);

    // Throws InvalidArgument. Setting the very pose that the body has is not a move.
    void set_pose(BodyId body, const Pose& pose);

    // Sets the pose of each body: all of them, or none if a call throws. For a body that is listed twice the later pose
    // holds. Throws InvalidArgument and StaleBody, with the index of the entry.
    void set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses);

    // Throws as create_body does. Setting the very object that the body has is not a change. A mesh that deforms is a
    // new shape each time.
    void set_shape(BodyId body, const std::shared_ptr<const Mesh>& mesh);
    void set_shape(BodyId body, std::shared_ptr<const Shape> shape);

    bool is_alive(BodyId body) const noexcept;
    Pose pose(BodyId body) const;
    std::shared_ptr<const Shape> shape(BodyId body) const;
    Aabb box(BodyId body) const;  // contains the exact body; of the pose and shape set last

    // A number of the caller's, kept with the body; 0 at first. It reaches no answer and no digest.
    void set_user_data(BodyId body, std::uint64_t data);
    std::uint64_t user_data(BodyId body) const;

    // All bodies, ascending; and the ids of bodies to come, in the order in which they are given while none is
    // destroyed: one for each free slot, and last the first one of a new slot (WorldOptions::ids). Cost: one pass.
    std::vector<BodyId> bodies() const;
    std::vector<BodyId> next_ids() const;

    // Reserves memory for so many bodies in all, so that creating them moves nothing.
    void reserve(std::size_t body_count);

    // ---- the clearance

    // From the next update on, close_pairs() are the pairs at a distance of at most this, decided for the real number;
    // or none, where nothing is given. The next update has events for what this changed. Throws InvalidArgument if it
    // is negative, NaN or infinity; or NotSupported if a test for two kinds of bodies that are here does not answer
    // `within`, as then create_body, set_shape and set_test do.
    void set_clearance(std::optional<double> clearance);
    std::optional<double> clearance() const;  // set last

    // ---- solids
    //
    // A body is a solid if its shape is a Solid (solid.hpp), and a surface in everything else, collisions included.

    // Whether updates make solid_pairs(), from the next one on; false at first.
    void set_solids(bool are_related);
    bool are_solids_related() const;  // set last

    // ---- which pairs are tested at all
    //
    // A pair is filtered out when the filters of its bodies say so, or when it is switched off. Its bodies are then not
    // tested, and the pair is in no list and no event, whether or not it shares a point; one that collides when it is
    // filtered out has ended, and one that collides when it is no more has begun, at the next update; so it is for
    // close pairs, and nearest(), closest_pair(), cast(), meetings(), depths() and solid_distances() pass over it.
    // Questions about a pair are answered regardless: they are about geometry.

    void set_filter(BodyId body, const CollisionFilter& filter);
    CollisionFilter filter(BodyId body) const;

    // Switches one pair off, or on again. Either order of arguments. It is forgotten when one of the two is destroyed.
    // Throws SameBody. Cost: logarithmic in the pairs that are off.
    void set_pair_enabled(BodyId a, BodyId b, bool is_enabled);
    bool is_pair_enabled(BodyId a, BodyId b) const;  // by that switch alone, whatever the filters are
    std::vector<BodyPair> disabled_pairs() const;    // all that are off, ascending; cost: one pass over them

    // ---- two-body tests

    // Registers the test for two kinds, in either order of arguments (the world swaps them); replaces what was there,
    // and forgets the verdicts that it gave. Meshes have one from the start. Throws InvalidArgument.
    void set_test(ShapeKind a, ShapeKind b, std::shared_ptr<const TwoBodyTest> test);

    // ---- answers for the whole world, as of the last update

    // Brings the lists below up to date. Work is proportional to what changed: pairs of which neither body changed
    // keep their verdict. When a caller's test throws, all other tests are still run; then the error of the pair that
    // comes first is thrown, the lists stay as they were, and the next update does the work again. The same holds when
    // the executor throws, or fails (ExecutorFailed).
    void update();

    // Pairs whose boxes overlap and that are not filtered out: the candidates, a superset of the colliding ones. How
    // tight boxes are is not promised, so this list, unlike all else, may differ between versions and rounding modes.
    // The list is made when it is asked for after an update that changed it: one pass over the candidates, and nothing
    // for those who never ask. After an update that threw, it is unspecified until one succeeds.
    std::span<const BodyPair> overlapping_pairs();

    // Pairs that share a point. Exact.
    std::span<const BodyPair> colliding_pairs() const;

    // Pairs that began and ended to collide with the last update. A destroyed body's collisions end.
    std::span<const BodyPair> began() const;
    std::span<const BodyPair> ended() const;

    // Pairs within the clearance that the last update was made with, colliding ones included; empty without one. Exact.
    std::span<const BodyPair> close_pairs() const;

    // Pairs that came to be within the clearance, and to be no more, with the last update; apart from began() and
    // ended(), but by the same rules.
    std::span<const BodyPair> close_began() const;
    std::span<const BodyPair> close_ended() const;

    // Pairs of solids that are not apart. Exact; empty unless set_solids(true) was called before the last update.
    std::span<const SolidPair> solid_pairs() const;

    // ---- answers for one pair, as of now

    // Either order of arguments. Throw StaleBody, SameBody, NotSupported. They change no answer, and work in the memory
    // that they are given, otherwise in the world's own, which is why those forms are not const. Those about distances
    // are as in distance.hpp: within() throws InvalidArgument, and infinity is allowed there; of several pairs of
    // features that tie, closest() chooses as if the body of the lesser id came first. intersections() and
    // close_features() are those of contact.hpp for the bodies in the order given.
    bool intersects(BodyId a, BodyId b, QueryMemory& memory) const;
    Relation relation(BodyId a, BodyId b, QueryMemory& memory) const;
    std::vector<TrianglePair> intersecting_triangles(BodyId a, BodyId b, QueryMemory& memory) const;
    double distance(BodyId a, BodyId b, QueryMemory& memory) const;
    bool within(BodyId a, BodyId b, double d, QueryMemory& memory) const;
    ClosestPoints closest(BodyId a, BodyId b, QueryMemory& memory) const;
    std::vector<TriangleIntersection> intersections(BodyId a, BodyId b, QueryMemory& memory) const;
    std::vector<CloseFeatures> close_features(BodyId a, BodyId b, double d, QueryMemory& memory) const;

    // As solids: solid.hpp, convex_solid.hpp and depth.hpp, with their errors; NotSupported if one of the two is no
    // Solid, or no ConvexSolid where that is asked for. Where several features tie, solid_closest() and depth() choose
    // as if the body of the lesser id came first, whichever moves; depth_bounds() is of the bodies in the order given.
    SolidRelation solid_relation(BodyId a, BodyId b, QueryMemory& memory) const;
    double solid_distance(BodyId a, BodyId b, QueryMemory& memory) const;
    std::optional<ClosestPoints> solid_closest(BodyId a, BodyId b, QueryMemory& memory) const;
    std::optional<Depth> depth(BodyId a, BodyId b, QueryMemory& memory) const;
    std::optional<DepthBounds> depth_bounds(BodyId a, BodyId b, QueryMemory& memory) const;

    bool intersects(BodyId a, BodyId b);
    Relation relation(BodyId a, BodyId b);
    std::vector<TrianglePair> intersecting_triangles(BodyId a, BodyId b);
    double distance(BodyId a, BodyId b);
    bool within(BodyId a, BodyId b, double d);
    ClosestPoints closest(BodyId a, BodyId b);
    std::vector<TriangleIntersection> intersections(BodyId a, BodyId b);
    std::vector<CloseFeatures> close_features(BodyId a, BodyId b, double d);
    SolidRelation solid_relation(BodyId a, BodyId b);
    double solid_distance(BodyId a, BodyId b);
    std::optional<ClosestPoints> solid_closest(BodyId a, BodyId b);
    std::optional<Depth> depth(BodyId a, BodyId b);
    std::optional<DepthBounds> depth_bounds(BodyId a, BodyId b);

    // ---- answers about what is no body, as of now; ascending

    // Bodies whose boxes share a point with this one: a superset of those that reach into it. Throws InvalidArgument.
    // Cost: that of BroadPhase::find.
    std::vector<BodyId> overlapping_bodies(const Aabb& box) const;

    // Bodies that share a point with a mesh or shape at a pose. Exact. Filters of bodies do not count, as the question
    // is about geometry; with a filter of its own, only bodies that it may meet. Throw as create_body does. Cost: as
    // above, and a two-body test for each box that overlaps. A Mesh that no body has gets a new tree each time: keep a
    // MeshShape to ask with it again.
    std::vector<BodyId> intersecting_bodies(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                            QueryMemory& memory, std::optional<CollisionFilter> filter = {}) const;
    std::vector<BodyId> intersecting_bodies(const Shape& shape, const Pose& pose, QueryMemory& memory,
                                            std::optional<CollisionFilter> filter = {}) const;

    std::vector<BodyId> intersecting_bodies(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                            std::optional<CollisionFilter> filter = {});
    std::vector<BodyId> intersecting_bodies(const Shape& shape, const Pose& pose,
                                            std::optional<CollisionFilter> filter = {});

    // Bodies that are solids with the point in them or on their surface. Exact. Throws InvalidArgument. Cost: that of
    // BroadPhase::find, and a locate() for each box that contains the point.
    BodiesContaining bodies_containing(const Vec3& point, QueryMemory& memory) const;
    BodiesContaining bodies_containing(const Vec3& point);

    // ---- which is the nearest, as of now (NearestBody says which of several)
    //
    // Nothing beyond `limit` is. Throw InvalidArgument if it is negative or NaN; and NotSupported if the test for two
    // kinds that are here, or for the kind asked with and one that is, does not answer both `distance` and `within`,
    // whichever bodies are near.

    // Of bodies with which this one is not filtered out.
    std::optional<NearestBody> nearest(BodyId body, QueryMemory& memory, double limit = no_limit) const;

    // As intersecting_bodies().
    std::optional<NearestBody> nearest(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, QueryMemory& memory,
                                       double limit = no_limit, std::optional<CollisionFilter> filter = {}) const;
    std::optional<NearestBody> nearest(const Shape& shape, const Pose& pose, QueryMemory& memory,
                                       double limit = no_limit, std::optional<CollisionFilter> filter = {}) const;

    // Of pairs that are not filtered out.
    std::optional<ClosestPair> closest_pair(QueryMemory& memory, double limit = no_limit) const;

    std::optional<NearestBody> nearest(BodyId body, double limit = no_limit);
    std::optional<NearestBody> nearest(const std::shared_ptr<const Mesh>& mesh, const Pose& pose,
                                       double limit = no_limit, std::optional<CollisionFilter> filter = {});
    std::optional<NearestBody> nearest(const Shape& shape, const Pose& pose, double limit = no_limit,
                                       std::optional<CollisionFilter> filter = {});
    std::optional<ClosestPair> closest_pair(double limit = no_limit);

    static constexpr double no_limit = std::numeric_limits<double>::infinity();

    // ---- pairs of convex solids, as of now; ascending
    //
    // Those that share a point, and those within `limit`, decided for the real number. Throw SingularPose if a convex
    // solid is at one, wherever it is; InvalidArgument if the limit is negative or NaN; without memory, ExecutorFailed.
    std::vector<BodyDepth> depths(QueryMemory& memory) const;
    std::vector<SolidDistance> solid_distances(double limit, QueryMemory& memory) const;
    std::vector<BodyDepth> depths();
    std::vector<SolidDistance> solid_distances(double limit);

    // ---- what is in the way, as of now
    //
    // What a segment or a ray meets (hit.hpp), of all bodies; with a filter, of those that it may meet. In the order
    // that BodyHit names. Throw InvalidArgument; and NotSupported if a kind that is here does not answer
    // hits, wherever its bodies are.
    std::optional<BodyHit> first_hit(const Segment& segment, QueryMemory& memory,
                                     std::optional<CollisionFilter> filter = {}) const;
    std::optional<BodyHit> first_hit(const Ray& ray, QueryMemory& memory,
                                     std::optional<CollisionFilter> filter = {}) const;
    std::vector<BodyHit> all_hits(const Segment& segment, QueryMemory& memory,
                                  std::optional<CollisionFilter> filter = {}) const;
    std::vector<BodyHit> all_hits(const Ray& ray, QueryMemory& memory,
                                  std::optional<CollisionFilter> filter = {}) const;

    std::optional<BodyHit> first_hit(const Segment& segment, std::optional<CollisionFilter> filter = {});
    std::optional<BodyHit> first_hit(const Ray& ray, std::optional<CollisionFilter> filter = {});
    std::vector<BodyHit> all_hits(const Segment& segment, std::optional<CollisionFilter> filter = {});
    std::vector<BodyHit> all_hits(const Ray& ray, std::optional<CollisionFilter> filter = {});

    // The body that is met first by this one, or by a mesh or shape at a pose, while it is translated by time times
    // `motion` (cast.hpp), up to `time_max`. Nothing moves. Bodies are passed over as by nearest(). Throw
    // InvalidArgument, also if `time_max` is negative or NaN (above 1 it is as 1), and otherwise as nearest(), for
    // `cast`.
    std::optional<BodyContact> cast(BodyId body, const Vec3& motion, QueryMemory& memory, double time_max = 1) const;
    std::optional<BodyContact> cast(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, const Vec3& motion,
                                    QueryMemory& memory, double time_max = 1,
                                    std::optional<CollisionFilter> filter = {}) const;
    std::optional<BodyContact> cast(const Shape& shape, const Pose& pose, const Vec3& motion, QueryMemory& memory,
                                    double time_max = 1, std::optional<CollisionFilter> filter = {}) const;

    std::optional<BodyContact> cast(BodyId body, const Vec3& motion, double time_max = 1);
    std::optional<BodyContact> cast(const std::shared_ptr<const Mesh>& mesh, const Pose& pose, const Vec3& motion,
                                    double time_max = 1, std::optional<CollisionFilter> filter = {});
    std::optional<BodyContact> cast(const Shape& shape, const Pose& pose, const Vec3& motion, double time_max = 1,
                                    std::optional<CollisionFilter> filter = {});

    // All pairs, but for those that are filtered out, that meet while each of the bodies goes from where it is to its
    // new pose, as Moving does, and the others stay, in the order that Meeting names. For a body listed twice the later
    // pose holds. Throws as set_poses(), and NotSupported if a test for kinds that are here does not answer it.
    std::vector<Meeting> meetings(std::span<const BodyId> bodies, std::span<const Pose> poses,
                                  QueryMemory& memory) const;
    std::vector<Meeting> meetings(std::span<const BodyId> bodies, std::span<const Pose> poses);

    // ---- a record of every call that changes the world (trace.hpp)

    // Begins a trace: writes what is here now, then every call as it succeeds. The stream must outlive the trace, which
    // ends with end_trace(), with the world, or with another trace_to(). It costs nothing when off; when on, the text,
    // and a digest at each update. Throws NotSupported when a body's shape cannot be written: no trace is then under
    // way. From then on, so do create_body and set_shape. A stream that fails ends the trace, and no call of the world.
    void trace_to(std::ostream& out, TraceOptions options = {});

    // Ends it, if there is one. Throws TraceFailed when not all of it could be written.
    void end_trace();

    // ---- inspection

    // colliding_pairs() and close_pairs() with their proof: certificate.hpp says more. Throws NotUpdated, NotSupported.
    WorldCertificate certify(QueryMemory& memory) const;
    Statistics statistics() const;

    // Checks every invariant, the broad phase's included, and kept verdicts by fresh tests, after an update that
    // succeeded. Throws BrokenInvariant; ShapeChanged when a caller's shape is not what it was. Slow: for tests.
    void validate() const;

    // A hash of the bodies (shapes, poses) and of which of them collide, as of the last update; where that was made
    // with a clearance, also of that and of the pairs within it; where with solids related, also of their pairs. Equal
    // scenes have equal digests, whatever their ids, history or broad phase. Filters count by the pairs that they
    // leave.
    std::uint64_t digest() const;

  private:
    struct ECODS_HIDDEN Impl;
    ECODS_HIDDEN Impl& impl();  // throw MovedFromWorld
    ECODS_HIDDEN const Impl& impl() const;

    std::unique_ptr<Impl> impl_;  // null: moved from
};

}  // namespace ecods
