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
#pragma once

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods {

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

// Return true if body and half space share a point; touching counts.
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

// Return the distance; 0 exactly if they intersect.
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

// Return true if the real distance is at most max_distance. Throw InvalidArgument for a negative distance or NaN.
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
