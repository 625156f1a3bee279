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

#include <optional>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

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

// Says when a body first goes into another one. Unlike a FirstContact, touching does not count: a cube on a floor
// slides and lifts without entering, and enters at 0 if it is pushed down.
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

// Returns when a, translated by time times `motion`, first goes into b, which stays; nullopt if it does not before
// max_time, in real time. A max_time above 1 counts as 1. (Parry has a related option: cast_shapes without
// stop_at_penetration.)
//
// Two solids: the infimum of the times from 0 on at which their interiors meet. They then meet at all times just after
// it; if they meet at the start, the time is 0, whatever max_time is. Two surfaces: the first time at which a triangle
// of a goes properly into or through one of b: the two share a point then, and not at time 0 alone; and seen along the
// motion, they overlap inside. So surfaces that lie on each other at the start do not enter (a sheet has no side), but
// surfaces that come to lie on each other do; and whether a lone sheet that moves edge on enters another one may depend
// on how both are cut into triangles, if the edge runs along a diagonal. Equal cubes, one on the other, pushed
// together, enter as solids, but not as surfaces: to ask about the surfaces of solids, pass surface_of(solid).
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

}  // namespace ecods
