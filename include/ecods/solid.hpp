// These questions are only about solids: where a point is, how deep two solids are in each other, and their signed
// distance. All other questions take solids, too (intersection.hpp, distance.hpp, hit.hpp, cast.hpp). No World is
// needed.
//
//     Solid hall{hall_mesh};
//     locate(Vec3(0, 0, 1), {hall, Pose{}}).side == Side::inside
//
// shape.hpp says which meshes bound a solid. A posed solid is the image of the set under R v + t. If R is singular, the
// image is flat and has no interior: it is the image of the surface. A flat convex solid has no interior at any pose,
// and at a singular pose is the image of its triangles.
//
// Answers are exact for the real points, and depend on the bits of meshes and poses alone; numbers are as in
// distance.hpp. Poses must be finite; a question does not check it. Threads are as in intersection.hpp. For coordinates
// so far apart in scale that their integers need thousands of bits, a question uses up to 256 KiB of stack.
//
// Example: verify/examples/how_do_i, inside_a_solid().
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class Rounded;  // rounded.hpp

// ---- solids of any form

// Returns whether the point is inside, outside or on the surface. A solid under a singular pose, and a flat solid, has
// no inside; all of a flat solid is its surface. Throws InvalidArgument unless the point is finite. Cost: a walk of the
// tree along a ray. (CGAL: side_of_triangle_mesh; trimesh: contains.)
[[nodiscard]] ECODS_API Location locate(const Vec3& point, const Posed<Solid>& solid, const Ask& ask = {});
// Returns locate() of each point, in the order of the points. The error's `index` says which point is not finite.
[[nodiscard]] ECODS_API std::vector<Location> locate(std::span<const Vec3> points, const Posed<Solid>& solid,
                                                     const Ask& ask = {});

// DepthBounds are proven bounds of the depth of two solids, convex or not. The depth is the length of the shortest
// translation of one of them after which their interiors share no point; for convex solids of which one is flat, it is
// that of depth().
//
// Upper bound: `parted` is a translation. If it replaces that of b's pose, b shares no inner point with a, as
// relation() says (with a flat solid, depth() is 0 or nothing); `upper` is |parted - b.pose.t|, rounded up. Lower
// bound: a ball inside each solid, since after a shorter translation the balls' interiors still meet; for convex
// solids, depth() rounded down. Both are 0 if the solids touch. Both bounds hold; how narrow they are is not promised,
// and may differ between versions. Along each direction that is tried, `upper` exceeds the length of the way out by at
// most about 2^-46 of it, and 2^-48 of the smaller solid's size, however large the other one is. `parted` consists of
// doubles: if their spacing at the pose's translation exceeds the depth, so does `upper`; it is infinite if no such
// translation parts the solids.
struct DepthBounds {
    double lower = 0;
    double upper = 0;
    Vec3 parted = Vec3::Zero();
};

// Returns proven bounds of the depth of two solids, convex or not; nullopt if they share no point. Throws SingularPose.
// Cost: some tens of relation(), of casts and of distances; for convex solids that of depth() and one or two of
// relation(). A flat solid and a solid that is not convex have no inner points in common: both bounds are 0.
[[nodiscard]] ECODS_API std::optional<DepthBounds> depth_bounds(const Posed<Solid>& a, const Posed<Solid>& b,
                                                                const Ask& ask = {});

// ---- convex solids (FCL, Coal: Convex; Bullet, Jolt: ConvexHullShape)
//
// The features of a convex solid are those of the set, however its faces are cut into triangles and its edges into
// pieces. A face is all of its solid in one plane, named by its least triangle, with corner 0. An edge is where two
// faces meet, named by the least side of a triangle that lies on it. A vertex is an end of edges, named by its least
// triangle and corner. All names have indices of the mesh; triangles of zero area name nothing, except in a segment or
// a point. A polygon has one face, a segment no face and one edge, and a point one vertex. Under a pose whose matrix is
// regular, the image of a convex solid is convex, and the images of its features are its features.
//
// Method: for distances, the search of Gilbert, Johnson and Keerthi (A fast procedure for computing the distance
// between complex objects, 1988) in doubles guesses the closest features. The signs of a few determinants prove the
// guess, since a point of a convex set that is closest among its neighbors is closest of all; if the signs do not prove
// it, exact steps continue from there. For depths, a polytope inside the set of differences { p - q : p in a, q in b }
// grows toward the faces that are nearest to the origin (van den Bergen, Proximity Queries and Penetration Depth
// Computation on 3D Game Objects, 2001), in doubles. Exact signs prove that these are faces of the set, and that no
// other face is nearer.

// Returns the depth: the length of the shortest translation of b after which the interiors share no point, and its
// direction. For a flat solid, which has no interior, it is the shortest translation after which a plane, closed half
// spaces counted, has one solid on each side; solids that are not flat have the same depth by this definition. So a rod
// that goes through a plate leaves it along or across itself, and the depth of sets in one plane is 0. Returns nullopt
// if the solids share no point (distance() says how far they are). signed_distance() also has the points that this
// translation brings together. Starts from a witness, and leaves one. Throws SingularPose. Cost: some microseconds for
// solids of some tens of faces; some tens of microseconds for ten thousand vertices.
[[nodiscard]] ECODS_API std::optional<Depth> depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                   const Ask& ask = {});

// A SignedDistance is the signed distance of two convex solids, of two rounded bodies (rounded.hpp), or of a body and a
// half space, and where it is attained. It is the distance of solids that share no point; otherwise
// minus the depth. It is 0 exactly if the solids touch: any other number is at least 2^-1074 in magnitude.
//
// Let n be the unit vector `direction`, and d the signed distance, as real numbers. Then point_b - point_a = d n. If d
// is positive, the points are the closest points, and n is the direction from point_a to point_b. Otherwise n is the
// direction of Depth, and translating b by -d n = point_a - point_b, the shortest translation after which the interiors
// share no point, brings the points together. If the solids touch, both points are one point that they share.
//
// The kind and the features are as in ClosestPoints: point_a is inside feature a, and point_b inside feature b. If
// several pairs of features have the same difference, for example in a common face, the first is given by the order of
// ClosestPoints. Exchanging the solids exchanges a and b and turns n around, unless several directions of Depth tie, or
// several pairs of features.
struct SignedDistance {
    double distance = 0;
    ClosestKind kind = ClosestKind::vertex_vertex;  // never `intersecting` or `contained`
    Feature a, b;
    Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();
    Vec3 direction = Vec3::Zero();

    friend bool operator==(const SignedDistance&, const SignedDistance&) = default;
};

// Returns the signed distance, the points and the direction; flat solids are allowed, too. signed_distance_bounds()
// (distance.hpp) takes meshes and solids of any form. Starts from a witness, and leaves one. Throws SingularPose. Cost:
// that of closest(), or that of distance(), depth() and, for the points, about one microsecond. (FCL, Coal:
// DistanceResult with enable_signed_distance; Bullet: btManifoldPoint.)
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b,
                                                       const Ask& ask = {});

// ---- half spaces

// A half space is one side of a plane: a ground, a wall, a safety plane. It is unbounded, and has no triangles.
//
//     const HalfSpace ground(Vec3::UnitZ(), 0);                  // everything with z <= 0
//     signed_distance({hull, pose}, {ground, Pose{}}).distance   // negative if the hull is partly below it
//
// Two-body questions take the body first and the half space second. A World takes a half space as the shape of a body,
// and answers intersects, relation, distance, signed_distance, within, closest, casts and hits, and contact_patch of a
// convex body (contact.hpp), in any order of the two. Rounded bodies (rounded.hpp) are supported, too. A body that
// turns (turn.hpp) has no cast against a half space: a World throws NotSupported, and two bodies have no such function.
// Two half spaces have questions of their own, below.
//
// Answers are exact for the real points, and depend on the bits of meshes, poses and half spaces alone; numbers are as
// in distance.hpp. A mesh, whatever its form, meets a half space if one of its vertices does, so surfaces and solids
// have the same answers, apart from relation(), which takes a flat convex solid for a surface. Cost of each question: a
// walk of the mesh's tree to its lowest vertices, and some microseconds for numbers that are rounded. Poses must be
// finite; a question does not check it. All questions throw SingularPose if the matrix of the half space's pose is
// singular: its image is then flat.
//
// Example: verify/examples/how_do_i, stand_on_the_ground().

// A HalfSpace is the set of points x with normal . x <= offset (FCL, Coal: Halfspace; Bullet: btStaticPlaneShape; Jolt:
// PlaneShape). The normal points out of the half space. It may have any length but 0, and is not normalised.
//
// Under a pose, the half space is the image of its points under R v + t, as for any other body. The normal of the posed
// half space is therefore the normal of the plane's image, which is R times the normal only if R is a rotation.
class ECODS_API HalfSpace final : public Shape {
  public:
    // Throws InvalidArgument if a number is NaN or infinite, or the normal is zero.
    HalfSpace(const Vec3& normal, double offset);

    const Vec3& normal() const noexcept { return normal_; }
    double offset() const noexcept { return offset_; }

    ShapeKind kind() const noexcept override { return ShapeKind::half_space(); }

    // Returns a box with infinite ends. If the posed normal is along an axis, the end on that side is finite, and
    // within one double of the plane. Throws SingularPose; calls of a World that give such a pose to a body throw it,
    // too.
    Aabb box(const Pose& pose) const override;
    std::uint64_t digest() const noexcept override;

    // Answer as hit.hpp says of a solid: a line that begins inside hits there, with parameter 0 and kind `inside`; and
    // a line hits the plane, coming from outside (`front`) or from inside (`back`). A line that touches the plane by
    // its end hits it. A line in the plane is `along` it, up to the line's end; the leaving point of a ray without end
    // is at infinity. A segment of length 0 in the plane has the kind `face`. The feature is a face, of triangle 0.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override;

  private:
    Vec3 normal_;
    double offset_;
};

// Return true if the body and the half space share a point; touching counts.
[[nodiscard]] ECODS_API bool intersects(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                        const Ask& ask = {});
[[nodiscard]] ECODS_API bool intersects(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space,
                                        const Ask& ask = {});

// Return the relation of the body to the half space. The body is apart; touching, if its lowest points are on the
// plane; inside, if it has no point outside and some point not on the plane; otherwise overlapping (a solid) or
// crossing (a surface). A body that lies in the plane is touching. A solid under a singular pose is touching wherever
// it shares a point.
[[nodiscard]] ECODS_API Relation relation(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                          const Ask& ask = {});
[[nodiscard]] ECODS_API Relation relation(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space,
                                          const Ask& ask = {});

// Return the distance of the body from the half space, rounded once; 0 exactly if they intersect.
[[nodiscard]] ECODS_API double distance(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                        const Ask& ask = {});
[[nodiscard]] ECODS_API double distance(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space,
                                        const Ask& ask = {});

// Return the signed distance, the points and the direction, as for two convex solids (SignedDistance). The signed
// distance is the distance of the body's lowest point from the plane; if that point is inside, minus the length of the
// shortest translation that takes the body out of the half space; 0 exactly if they touch. This holds for bodies of any
// form, also with dents, since only translations across the plane part the two. The points are the body's lowest
// vertex, or the lowest point of the ball around it, and the foot of the perpendicular on the plane. The features are
// those of closest() for a body outside. The direction is the one from outside to the plane. If several vertices are
// lowest, the first is given, by triangle and corner.
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                                       const Ask& ask = {});
[[nodiscard]] ECODS_API SignedDistance signed_distance(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space,
                                                       const Ask& ask = {});

// Return true if the real distance of the body from the half space is at most max_distance. Throw InvalidArgument if
// max_distance is negative or NaN.
[[nodiscard]] ECODS_API bool within(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                    double max_distance, const Ask& ask = {});
[[nodiscard]] ECODS_API bool within(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space, double max_distance,
                                    const Ask& ask = {});

// Return the distance and two closest points: the body's lowest vertex, and the foot of its perpendicular on the plane,
// which is the face of triangle 0. If several vertices are lowest, the first is given, by triangle and corner. If that
// vertex is in the half space, the kind is `contained`: the distance is 0, both points are that vertex, and the half
// space's feature is no_feature. For a rounded body outside the half space, the point is the lowest point of the ball
// around the vertex.
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<MeshShape>& body, const Posed<HalfSpace>& half_space,
                                              const Ask& ask = {});
[[nodiscard]] ECODS_API ClosestPoints closest(const Posed<Rounded>& body, const Posed<HalfSpace>& half_space,
                                              const Ask& ask = {});

// Return the first contact of the body, translated by time times `motion`, with the half space; nullopt if the real
// time is above max_time. The features are the lowest vertex, as in closest(), and the face of triangle 0; if the two
// intersect at time 0, the features are those of closest(). Throw InvalidArgument if a coordinate of the motion is not
// finite, or max_time is NaN or negative. A max_time above 1 counts as 1.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& body, const Vec3& motion,
                                                         const Posed<HalfSpace>& half_space, double max_time = 1,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<Rounded>& body, const Vec3& motion,
                                                         const Posed<HalfSpace>& half_space, double max_time = 1,
                                                         const Ask& ask = {});

// Return the first contact of a body whose points move on straight lines between two poses (cast.hpp), or of a rounded
// body whose core moves like this. The half space may be translated. If its matrix changes, even in the sign of a zero,
// the calls throw NotSupported, with both kinds. Of several vertices that touch first, the first is given.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& body,
                                                         const Moving<HalfSpace>& half_space, double max_time = 1,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<Rounded>& body,
                                                         const Moving<HalfSpace>& half_space, double max_time = 1,
                                                         const Ask& ask = {});

// Answer the questions about two half spaces. Two half spaces intersect unless their planes are parallel and their
// normals opposed. Their relation is never crossing.
[[nodiscard]] ECODS_API bool intersects(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API Relation relation(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API double distance(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, const Ask& ask = {});
[[nodiscard]] ECODS_API bool within(const Posed<HalfSpace>& a, const Posed<HalfSpace>& b, double max_distance,
                                    const Ask& ask = {});

// Return the first contact of two half spaces: the first is translated by time times `motion`, or both move between
// poses. The time is rational, and rounded once. The kind is `intersecting`, and the features are the faces of triangle
// 0. If the two are apart at the start, neither matrix may change, not even the sign of a zero: throw NotSupported.
// Throw InvalidArgument as casts of bodies do.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<HalfSpace>& a, const Vec3& motion,
                                                         const Posed<HalfSpace>& b, double max_time = 1,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<HalfSpace>& a, const Moving<HalfSpace>& b,
                                                         double max_time = 1, const Ask& ask = {});

}  // namespace ecods
