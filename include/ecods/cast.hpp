// Casts find when a moving body first shares a point with another body (FCL: continuousCollide; Parry: cast_shapes;
// Box3D: time of impact). No World is needed.
//
//     std::optional<FirstContact> contact = cast({cube, pose_a}, motion, {cube, pose_b});
//     if (contact) contact->time, contact->a, contact->b
//
// There are two kinds of motion, in the time from 0 to 1. Translation by m: at time s a body is at the real points R v
// + t + s m. Straight motion between two poses: each point moves from R0 v + t0 to R1 v + t1 on a straight line, at
// constant speed, so at time s the pose's entries are (1 - s) (R0, t0) + s (R1, t1), as real numbers. Such a motion is
// no rotation: halfway through half a turn the body is flat. Split a long turn into short moves.
//
// Contact is decided for the real numbers: contact at time 0 and at the last time counts, and so does grazing. The time
// is the least real time, rounded once (distance.hpp says how); a positive time is at least 2^-1074. So the time is 0
// exactly if the bodies share a point at the start. Equal input gives equal bits, in any rounding mode.
//
// Everything is defined for all finite poses and motions and for zero-area triangles, also for bodies that become flat
// while they move. Bodies and threads are as in intersection.hpp.
//
// Example: verify/examples/how_do_i, cast_on_its_way().
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

class Rounded;  // rounded.hpp

// Bodies are as in intersection.hpp. If a part of one is inside the other at the start, the first contact is at time 0.

// Returns the first contact of a, translated by time times `motion`, with b, which stays; nullopt if there is none up
// to max_time, in real time. Starts from a witness, and leaves the triangles that decided. Throws InvalidArgument if a
// coordinate of the motion is not finite, or max_time is negative or NaN. A max_time above 1 counts as 1. Cost: a walk
// of both trees, earliest boxes first. A pair of triangles that is a candidate costs some tenths of a microsecond; the
// last one or few, which are compared exactly, about one microsecond. If faces meet face on, all pairs that touch first
// are compared exactly, at some microseconds each. A short motion costs about as much as the distance at its end.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion,
                                                         const Posed<MeshShape>& b, double max_time = 1,
                                                         const Ask& ask = {});

// Returns the first contact of two bodies that each move from one pose to another; nullopt if there is none up to
// max_time. Cost: as above, and a few times as much. The exact decision of two triangles, usually one in a cast, takes
// some tens of microseconds; for triangles that graze each other a tenth of a millisecond; and if some numbers are
// 2^600 times as large as others, tens of milliseconds.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});

// ---- entering: the first time after which bodies are inside each other

// A FirstEntry says when a body first goes into another one. Touching is no entry: a cube on a floor slides and lifts
// without entering the floor, and enters at time 0 if it is pushed down.
struct FirstEntry {
    double time = 0;  // rounded once, at least 2^-1074 unless it is 0
    // a and b are the faces of two triangles that go into each other at this time: the least of all pairs whose time
    // rounds to `time`. Both are no_feature if inner points of two solids meet at the start.
    Feature a, b;

    friend bool operator==(const FirstEntry&, const FirstEntry&) = default;
};

// A BodyEntry is an entry into a body of a World.
struct BodyEntry {
    BodyId body;
    FirstEntry entry;  // `entry.b` is a face of the body

    friend bool operator==(const BodyEntry&, const BodyEntry&) = default;
};

// Returns the first entry of a, translated by time times `motion`, into b, which stays; nullopt if a does not enter b
// before max_time, in real time. A max_time above 1 counts as 1. (Parry has a related option: cast_shapes without
// stop_at_penetration.)
//
// For two solids, the time is the infimum of the times from 0 on at which their interiors meet. The interiors then meet
// at all times just after it; if they meet at the start, the time is 0, whatever max_time is. For two surfaces, it is
// the first time at which a triangle of a goes properly into or through a triangle of b: the two triangles share a
// point then, and not at time 0 alone; and seen along the motion, their interiors overlap. So surfaces that lie on each
// other at the start do not enter (a sheet has no side), but surfaces that come to lie on each other do. Whether a lone
// sheet that moves edge on enters another one may depend on how both are cut into triangles, if the edge runs along a
// diagonal. Equal cubes, one on the other, pushed together, enter as solids, but not as surfaces: to ask about the
// surfaces of solids, pass surface_of(solid).
//
// Bodies rarely lie on each other exactly. A body that is put down at a rounded translation is in the floor by an ulp
// half of the time, and then enters at 0 whatever the direction; a direction that is tangential up to rounding goes
// into a tilted floor. So let bodies stop at pose_before(), and keep a distance from tilted floors.
//
// Throws InvalidArgument if a coordinate of the motion is not finite, or max_time is negative or NaN; NotSupported for
// a solid and a surface, and if a body is a flat solid or a solid at a singular pose. Neither starts from a witness nor
// leaves one. Cost: for solids solid_relation() at the start; then about that of cast(), and one or two microseconds
// for each pair of triangles that touches before something enters.
[[nodiscard]] ECODS_API std::optional<FirstEntry> entering(const Posed<MeshShape>& a, const Vec3& motion,
                                                           const Posed<MeshShape>& b, double max_time = 1,
                                                           const Ask& ask = {});

// Returns a pose near the way of a, at `time` or before, at which a is proven not to be in b: relation() is apart or
// touching there. The pose has the rotation of a, and the translation of a at some time, rounded. Returns nullopt if
// the bodies share inner points even at the start. Usually that time is a few ulps less than `time`; this is not
// promised, and nothing is promised about poses between the start and the result. Throws InvalidArgument if the motion
// is not finite, or the time not from 0 to 1. Cost: some calls of relation(), at most 54.
[[nodiscard]] ECODS_API std::optional<Pose> pose_before(const Posed<MeshShape>& a, const Vec3& motion,
                                                        const Posed<MeshShape>& b, double time, const Ask& ask = {});

// ---- casts to a distance

// cast_to_distance() finds when a translated body is first within a distance of another one. (Parry: target_distance of
// cast_shapes; Box2D: a time of impact with a target.) No World is needed.
//
//     if (auto contact = cast_to_distance({drone, pose_a}, motion, {house, pose_b}, 0.5)) contact->time
//
// The time is the least real time from 0 on at which the distance of the bodies is at most `distance`, decided for real
// numbers and rounded once (distance.hpp says how): a body that comes to exactly that distance, or passes at it, is
// found. A positive time is at least 2^-1074, so the time is 0 exactly if the bodies are within the distance at the
// start. Bodies that share a point, and a body inside a solid, have the distance 0. With the distance 0, the answer is
// that of cast().
//
// Kind and features are those of the closest points at the time, by the rule of FirstContact: they name where the
// bodies are closest. At time 0 they are those of closest(). Of rounded bodies they are those of the cores.
//
// Everything is defined for all finite poses and motions and for zero-area triangles. Bodies and threads are as in
// intersection.hpp. Only translations are answered: there is no cast_to_distance of a straight motion between two poses
// or of a turn. World::cast_to_distance() asks about all bodies of a World.
//
// Method: the question is a cast of rounded bodies whose radii add up to the distance (rounded.hpp).
//
// Example: verify/examples/how_do_i, stop_at_a_distance().

// Return the first time at which a, translated by time times `motion`, is within `distance` of b, which stays; nullopt
// if there is no such time up to max_time, in real time. For rounded bodies, the distance is that of their surfaces:
// the radii and `distance` are added exactly. Start from a witness. Throw InvalidArgument if the distance is negative,
// NaN or infinite, a coordinate of the motion is not finite, or max_time is negative or NaN. A max_time above 1 counts
// as 1. Cost: that of a cast of rounded bodies; with the distance 0 and no radii, that of cast().
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion,
                                                                     const Posed<MeshShape>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion,
                                                                     const Posed<Rounded>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion,
                                                                     const Posed<MeshShape>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion,
                                                                     const Posed<Rounded>& b, double distance,
                                                                     double max_time = 1, const Ask& ask = {});

// ---- meshes that deform

// A Deforming mesh has other vertices at time 1 than at time 0: cloth, skin, soft bodies, the steps of a simulation.
// Casts of it find when it first shares a point with another body. (Continuous collision detection of vertices and
// faces, edges and edges: Provot 1997; Brochu, Edwards and Bridson 2012.) No World is needed.
//
//     const Deforming cloth(shape, vertices_at_the_end);
//     if (auto contact = cast(cloth, {floor, Pose()})) contact->time, contact->a, contact->b
//
// At a time s from 0 to 1, each vertex is at the real point (1 - s) v0 + s v1, in the coordinates of the world, and
// each triangle is the one that its vertices then span: so the mesh may stretch, fold, become flat or turn inside out.
// The mesh is a surface, also if its shape is a solid; a body that it is inside of, or that is inside of it, is met as
// intersects() says of a surface. All else is as in cast.hpp: contact at time 0 and at the last time counts, and so
// does grazing; the time is the least real time, rounded once; everything is defined for zero-area triangles and for
// meshes that become flat; and equal input gives equal bits. A vertex alone is a triangle {i, i, i} and an edge alone a
// triangle {i, j, j}.
//
// Contacts of a mesh with itself are not found, nor is there a cast of a deforming mesh with a body that turns, with a
// rounded body or with a half space. World::cast() takes a deforming mesh against the bodies of a World, at rest.
//
// Example: verify/examples/how_do_i, cast_a_cloth().
// Example: verify/examples/how_do_i, cast_a_cloth_in_a_world().

// A Deforming is immutable. Copies share their data, and several threads may ask about one at the same time.
class ECODS_API Deforming {
  public:
    // Takes the mesh of the shape at time 0, and the place of each of its vertices at time 1. For a step that goes on
    // from this one, pass refit(shape, vertices) as the shape. Throws InvalidArgument for a null shape; InvalidMesh for
    // a coordinate that is not finite, and if there are too few vertices; further vertices are ignored. Cost: the tree
    // of the shape if it has none yet, and some passes over the triangles.
    Deforming(std::shared_ptr<const MeshShape> shape, std::vector<Vec3> vertices_at_end);

    const std::shared_ptr<const MeshShape>& shape() const noexcept;  // at time 0
    const Mesh& mesh_at_end() const noexcept;                        // at time 1
    const Aabb& box() const noexcept;  // the least box that contains all triangles at all times

  private:
    friend struct DeformingAccess;
    struct ECODS_HIDDEN Parts;
    std::shared_ptr<const Parts> parts_;
};

// Return the first contact of a deforming mesh with a body at rest, a body that moves from one pose to another, or
// another deforming mesh, in either order; nullopt if there is none up to max_time. If a part of one body is inside a
// solid at the start, the first contact is at time 0. Start from a witness, and leave the triangles that decided. Throw
// InvalidArgument if max_time is negative or NaN; a max_time above 1 counts as 1.
//
// Cost: that of cast() of moving bodies, as long as triangles that are near each other at time 0 stay near each other:
// the tree of boxes is that of time 0, with boxes at both ends of the motion. Meshes above 2^200 or below 2^-200 cost
// much more.
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Posed<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Deforming& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Moving<MeshShape>& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Moving<MeshShape>& a, const Deforming& b,
                                                         double max_time = 1, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<FirstContact> cast(const Deforming& a, const Deforming& b, double max_time = 1,
                                                         const Ask& ask = {});

}  // namespace ecods
